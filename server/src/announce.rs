//! What the terminal shows when the server is ready: the address, and the code for phones.

use std::fmt::Write;

use qrcode::QrCode;
use qrcode::render::unicode::Dense1x2;

use crate::RunningApp;
use crate::cell::RobotSettings;

/// The ready line, where controllers are awaited, and for a server on the network the pairing code with its QR code.
pub fn announcement(app: &RunningApp) -> String {
    // Writing to a string can't fail.
    let mut text = format!("TEAM is ready: {}\n", app.url());
    if let Some(url) = app.url_without_certificate() {
        let _ = writeln!(text, "Without this cell's certificate: {url}");
    }
    if let Some(fingerprint) = app.certificate_sha256() {
        let _ = writeln!(text, "The certificate's SHA-256 fingerprint: {fingerprint}");
    }
    if app.robots().len() > 1 || app.robots().iter().any(|robot| robot.controller.is_some()) {
        for robot in app.robots() {
            let _ = writeln!(text, "{}", in_a_line(robot));
        }
    }
    if let (Some(code), Some(url)) = (app.pairing_code(), app.pairing_url()) {
        let (first, second) = code.split_at(4);
        let _ = writeln!(text, "Pairing code: {first} {second}");
        let joining = app.joining_url();
        let pictures = match &joining {
            None => vec![("Scan it with the phone's camera:", url.as_str())],
            Some(joining) => vec![
                (
                    "A new phone: scan this, it leads through.",
                    joining.as_str(),
                ),
                ("A phone that has the certificate:", url.as_str()),
            ],
        };
        for (words, url) in pictures {
            if let Some(picture) = qr(url) {
                let _ = writeln!(text, "{words} {url}\n{picture}");
            }
        }
    }
    text
}

/// A robot as whoever sets up its controller needs it.
fn in_a_line(robot: &RobotSettings) -> String {
    let RobotSettings {
        id,
        name,
        egm_listen,
        ..
    } = robot;
    match &robot.controller {
        Some(controller) => {
            let rws_url = &controller.rws_url;
            format!("{name} ({id}): a GoFa at {rws_url}, EGM on {egm_listen}")
        }
        None => format!("{name} ({id}): a virtual robot"),
    }
}

/// A QR code out of half blocks. What is drawn is bright on a dark terminal, so the code's bright
/// parts are drawn and its dark ones left out.
fn qr(url: &str) -> Option<String> {
    let code = QrCode::new(url).ok()?;
    let drawing = code
        .render::<Dense1x2>()
        .dark_color(Dense1x2::Light)
        .light_color(Dense1x2::Dark)
        .build();
    Some(drawing)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_qr_code_is_a_square_of_half_blocks_with_a_bright_border() {
        let picture = qr("http://192.0.2.1:8080/#pair=04711815").unwrap();
        let lines: Vec<&str> = picture.lines().collect();
        let width = lines[0].chars().count();
        assert!(lines.iter().all(|line| line.chars().count() == width));
        assert_eq!(lines.len(), width.div_ceil(2));
        assert!(
            lines[0].chars().all(|c| c == '█'),
            "the quiet zone is bright"
        );
    }
}
