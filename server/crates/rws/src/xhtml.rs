//! Reading the controller's XHTML: the only form of its subscription events, and the form it falls
//! back to where it has no JSON.
//!
//! Each `<li class="TYPE" title="…">` is an entry, each `<span class="NAME">` in it a field. This is
//! no XML parser: it looks for these two elements and skips everything else.

use serde_json::{Map, Value};

/// The entries of a document, in the shape that the JSON answers have: `_type`, `_title`, the
/// address of the resource as `_href`, and the fields as strings.
pub(crate) fn entries(text: &str) -> Vec<Map<String, Value>> {
    let mut entries = Vec::new();
    let mut open: Option<Map<String, Value>> = None;
    for (tag, content) in tags(text) {
        match (tag.name, &mut open) {
            ("li", _) => {
                entries.extend(open.take());
                let mut entry = Map::new();
                entry.insert("_type".to_owned(), tag.attribute("class").into());
                entry.insert("_title".to_owned(), tag.attribute("title").into());
                open = Some(entry);
            }
            ("/li", _) => entries.extend(open.take()),
            ("a", Some(entry)) if tag.attribute("rel") == "self" => {
                entry.insert("_href".to_owned(), tag.attribute("href").into());
            }
            ("span", Some(entry)) => {
                entry.insert(tag.attribute("class"), unescaped(content.trim()).into());
            }
            _ => {}
        }
    }
    entries.extend(open);
    entries
}

/// The text of the first `<span class="name">`, wherever it stands.
pub(crate) fn span(text: &str, name: &str) -> Option<String> {
    tags(text)
        .find(|(tag, _)| tag.name == "span" && tag.attribute("class") == name)
        .map(|(_, content)| unescaped(content.trim()))
}

/// A tag without its angle brackets.
struct Tag<'a> {
    name: &'a str,
    attributes: &'a str,
}

impl Tag<'_> {
    fn attribute(&self, name: &str) -> String {
        let mut rest = self.attributes;
        while let Some((before, after)) = rest.split_once('=') {
            let Some(quote) = after
                .trim_start()
                .chars()
                .next()
                .filter(|c| "\"'".contains(*c))
            else {
                return String::new();
            };
            let mut parts = after.trim_start()[1..].splitn(2, quote);
            let value = parts.next().unwrap_or_default();
            if before.trim() == name {
                return unescaped(value);
            }
            rest = parts.next().unwrap_or_default();
        }
        String::new()
    }
}

/// Every tag with the text that follows it.
fn tags(text: &str) -> impl Iterator<Item = (Tag<'_>, &str)> {
    text.split('<').skip(1).filter_map(|piece| {
        let (tag, content) = piece.split_once('>')?;
        let tag = tag.trim_end_matches('/');
        let (name, attributes) = tag.split_once(char::is_whitespace).unwrap_or((tag, ""));
        Some((Tag { name, attributes }, content))
    })
}

fn unescaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut pieces = text.split('&');
    out.push_str(pieces.next().unwrap_or_default());
    for piece in pieces {
        let known = piece
            .split_once(';')
            .and_then(|(name, rest)| Some((character(name)?, rest)));
        match known {
            Some((character, rest)) => {
                out.push(character);
                out.push_str(rest);
            }
            None => {
                out.push('&');
                out.push_str(piece);
            }
        }
    }
    out
}

fn character(name: &str) -> Option<char> {
    match name {
        "amp" => Some('&'),
        "lt" => Some('<'),
        "gt" => Some('>'),
        "quot" => Some('"'),
        "apos" => Some('\''),
        _ => {
            let number = name.strip_prefix('#')?;
            let code = match number.strip_prefix(['x', 'X']) {
                Some(digits) => u32::from_str_radix(digits, 16),
                None => number.parse(),
            };
            char::from_u32(code.ok()?)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn an_event_gives_its_type_its_resource_and_its_value() {
        let text = r#"<?xml version="1.0"?><html><body><div class="state"><ul>
            <li class="ios-signalstate-ev" title="a &amp; b"><a href="/rw/iosystem/signals/x;state" rel="self"/>
            <span class="lvalue">1</span><span class='lstate'>not &#34;simulated&#x22;</span></li>
            <li class="elog-message-ev"><a href="/rw/elog/0/7" rel="self"></a></li></ul></div></body></html>"#;
        let found = entries(text);
        assert_eq!(found.len(), 2);
        assert_eq!(found[0]["_type"], "ios-signalstate-ev");
        assert_eq!(found[0]["_title"], "a & b");
        assert_eq!(found[0]["_href"], "/rw/iosystem/signals/x;state");
        assert_eq!(found[0]["lvalue"], "1");
        assert_eq!(found[0]["lstate"], "not \"simulated\"");
        assert_eq!(found[1]["_href"], "/rw/elog/0/7");
    }

    #[test]
    fn a_refusal_has_its_spans_outside_of_any_entry() {
        let text = r#"<div class="status"><span class="code">-757</span><span class="msg">no &lt;grant&gt;</span></div>"#;
        assert!(entries(text).is_empty());
        assert_eq!(span(text, "code").unwrap(), "-757");
        assert_eq!(span(text, "msg").unwrap(), "no <grant>");
    }

    proptest! {
        #[test]
        fn whatever_comes_is_read_without_a_panic(text in "[<>/a-z \"'=;&#x0-9é]{0,80}") {
            entries(&text);
            span(&text, "code");
        }
    }
}
