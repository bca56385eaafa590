//! The string literals of a Rust source, with what stands around them: enough of a reader to tell
//! a sentence for people from a log line, an attribute or a test.

/// One string literal.
pub(super) struct Literal {
    pub(super) text: String,
    pub(super) line: usize,
    /// The field or name that it is given to, or `=>`.
    pub(super) before: String,
    /// The function or macro that is called with it.
    pub(super) call: String,
    /// The function or macro whose body it stands in.
    pub(super) inside: String,
}

/// Macros whose words are for the log or for whoever mends a bug.
const FOR_DEVELOPERS: [&str; 15] = [
    "trace",
    "debug",
    "info",
    "warn",
    "error",
    "event",
    "panic",
    "unreachable",
    "assert",
    "assert_eq",
    "assert_ne",
    "debug_assert",
    "debug_assert_eq",
    "prop_assert",
    "concat",
];

enum Token {
    Word(String),
    Sign(char),
    Text(String),
}

/// Every literal of the source that may be shown to somebody: not those of tests, of attributes
/// other than `#[error(…)]`, of the log and of `expect`.
pub(super) fn literals(source: &str) -> Vec<Literal> {
    let tokens = tokens(source);
    let mut found = Vec::new();
    let mut frames: Vec<Frame> = Vec::new();
    let (mut function, mut test_item) = (None, false);
    for (at, (token, line)) in tokens.iter().enumerate() {
        let back = |steps: usize| at.checked_sub(steps).map(|at| &tokens[at].0);
        match token {
            Token::Word(word) => {
                if let ("fn", Some(Token::Word(name))) =
                    (word.as_str(), tokens.get(at + 1).map(|(token, _)| token))
                {
                    function = Some(name.clone());
                }
            }
            Token::Sign(sign @ ('(' | '[' | '{')) => {
                let after = |steps: usize| tokens.get(at + steps).map(|(token, _)| token);
                let attribute = *sign == '[' && is_sign(back(1), '#');
                let for_tests = attribute && is_word(after(1), "cfg") && is_word(after(3), "test");
                let macro_name = is_sign(back(1), '!').then(|| word(back(2)));
                let hidden = frames.last().is_some_and(|frame| frame.hidden)
                    || attribute && !is_word(after(1), "error")
                    || *sign == '(' && is_word(back(1), "expect")
                    || *sign == '{' && std::mem::take(&mut test_item)
                    || macro_name.is_some_and(|name| FOR_DEVELOPERS.contains(&name));
                test_item |= for_tests;
                let body = match (macro_name, *sign) {
                    (Some(name), _) => name.to_owned(),
                    (None, '{') => function.take().unwrap_or_default(),
                    _ => String::new(),
                };
                let called = macro_name.unwrap_or_else(|| word(back(1))).to_owned();
                frames.push(Frame {
                    hidden,
                    body,
                    called,
                });
            }
            Token::Sign(')' | ']' | '}') => {
                frames.pop();
            }
            Token::Sign(';') if frames.last().is_none_or(|frame| !frame.hidden) => {
                test_item = false;
                function = None;
            }
            Token::Sign(_) => {}
            Token::Text(text) => {
                if test_item || frames.last().is_some_and(|frame| frame.hidden) {
                    continue;
                }
                let mut bodies = frames.iter().rev().map(|frame| frame.body.as_str());
                let before = match back(1) {
                    Some(Token::Sign('>')) => "=>",
                    // `const WHAT: &str = "…"`
                    Some(Token::Sign('=')) if is_word(back(2), "str") => word(back(5)),
                    Some(Token::Sign(':' | '=')) => word(back(2)),
                    _ => "",
                };
                let call = frames.last().map_or("", |frame| frame.called.as_str());
                found.push(Literal {
                    text: text.clone(),
                    line: *line,
                    before: before.to_owned(),
                    call: call.to_owned(),
                    inside: bodies
                        .find(|name| !name.is_empty())
                        .unwrap_or_default()
                        .to_owned(),
                });
            }
        }
    }
    found
}

/// What one bracket holds.
struct Frame {
    hidden: bool,
    body: String,
    called: String,
}

fn word(token: Option<&Token>) -> &str {
    match token {
        Some(Token::Word(word)) => word,
        _ => "",
    }
}

fn is_word(token: Option<&Token>, wanted: &str) -> bool {
    word(token) == wanted
}

fn is_sign(token: Option<&Token>, wanted: char) -> bool {
    matches!(token, Some(Token::Sign(sign)) if *sign == wanted)
}

fn tokens(source: &str) -> Vec<(Token, usize)> {
    let mut tokens = Vec::new();
    let (mut rest, mut line) = (source, 1);
    while let Some(first) = rest.chars().next() {
        let (token, length) = match first {
            _ if rest.starts_with("//") => (None, rest.find('\n').unwrap_or(rest.len())),
            '"' => quoted(rest),
            'r' | 'b' if starts_raw(rest) => raw(rest),
            '\'' => (None, quote(rest)),
            _ if first.is_alphanumeric() || first == '_' => {
                let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_'));
                let length = end.unwrap_or(rest.len());
                (Some(Token::Word(rest[..length].to_owned())), length)
            }
            _ if first.is_whitespace() => (None, first.len_utf8()),
            _ => (Some(Token::Sign(first)), first.len_utf8()),
        };
        tokens.extend(token.map(|token| (token, line)));
        line += rest[..length].matches('\n').count();
        rest = &rest[length..];
    }
    tokens
}

fn starts_raw(rest: &str) -> bool {
    rest.trim_start_matches('b')
        .strip_prefix('r')
        .is_some_and(|rest| rest.trim_start_matches('#').starts_with('"'))
}

fn raw(rest: &str) -> (Option<Token>, usize) {
    let begins = rest.find('"').unwrap_or(0) + 1;
    let marks = rest[..begins].matches('#').count();
    let end = format!("\"{}", "#".repeat(marks));
    let length = rest[begins..].find(&end).unwrap_or(0);
    let text = rest[begins..begins + length].to_owned();
    (Some(Token::Text(text)), begins + length + end.len())
}

fn quoted(rest: &str) -> (Option<Token>, usize) {
    let (mut text, mut skips_space) = (String::new(), false);
    let mut letters = rest.char_indices().skip(1);
    while let Some((at, letter)) = letters.next() {
        if skips_space && letter.is_whitespace() {
            continue;
        }
        skips_space = false;
        match letter {
            '"' => return (Some(Token::Text(text)), at + 1),
            '\\' => match letters.next() {
                Some((_, '\n')) => skips_space = true,
                Some((_, 'n')) => text.push('\n'),
                Some((_, other)) => text.push(other),
                None => break,
            },
            letter => text.push(letter),
        }
    }
    (Some(Token::Text(text)), rest.len())
}

/// Over a character such as `'"'`; of a lifetime only the quote.
fn quote(rest: &str) -> usize {
    let mut letters = rest.char_indices().skip(1);
    let character = match letters.next() {
        Some((_, '\\')) => letters.find(|(_, letter)| *letter == '\''),
        Some(_) => letters.next().filter(|(_, letter)| *letter == '\''),
        None => None,
    };
    character.map_or(1, |(at, _)| at + 1)
}

#[test]
fn only_what_people_may_see_is_read() {
    let source = r##"
        #[expect(dead_code, reason = "not this")]
        #[error("the arm is {state}; \
                 wait")]
        fn words(&'a self) -> &'static str {
            tracing::warn!("not this");
            file.expect("not this");
            match letter { '"' => "one", _ => r#"an "odd" one"# }
        }
        #[cfg(test)]
        mod tests { fn it() { "not this" } }
        const LAST: &str = "last"; // "not this"
    "##;
    let found = literals(source);
    let texts: Vec<&str> = found.iter().map(|literal| literal.text.as_str()).collect();
    assert_eq!(
        texts,
        ["the arm is {state}; wait", "one", "an \"odd\" one", "last"]
    );
    assert_eq!(
        (found[1].before.as_str(), found[1].inside.as_str()),
        ("=>", "words")
    );
}
