//! From the address to the log-in: without these nothing else means anything.

use rws::{Client, RwsError};
use tokio::net::TcpStream;
use tokio::time::timeout;

use super::report::{Report, Step};
use super::{ANSWER_WITHIN, Args, client};

/// Connects, and sends nothing.
pub async fn address(arguments: &Args, report: &mut Report) -> Result<(), String> {
    const WHY: &str = "the controller cannot be reached";
    let Some(authority) = authority(&arguments.rws) else {
        report.failed(
            Step::Address,
            format!("\"{}\" is no address", arguments.rws),
            "Write it as https://192.168.125.1.",
        );
        return Err(WHY.to_owned());
    };
    let seen = match timeout(ANSWER_WITHIN, TcpStream::connect(&authority)).await {
        Ok(Ok(_)) => {
            report.ok(Step::Address, authority);
            return Ok(());
        }
        Ok(Err(error)) => error.to_string(),
        Err(_) => "no answer in time".to_owned(),
    };
    report.failed(
        Step::Address,
        format!("{authority}: {seen}"),
        "Check that the controller is switched on, its network cable, that this computer has an address in the same network, and that the controller's firewall lets Robot Web Services through on this port.",
    );
    Err(WHY.to_owned())
}

/// `host:port` of an http or https address.
fn authority(url: &str) -> Option<String> {
    let (scheme, rest) = url.split_once("://")?;
    let port = match scheme {
        "https" => 443,
        "http" => 80,
        _ => return None,
    };
    let authority = rest.split(['/', '?', '#']).next()?;
    let after_address = authority.rsplit(']').next()?;
    match authority.is_empty() {
        true => None,
        false if after_address.contains(':') => Some(authority.to_owned()),
        false => Some(format!("{authority}:{port}")),
    }
}

/// Looks at the certificate before anything is sent to whoever shows it.
pub async fn certificate(arguments: &Args, report: &mut Report) -> Result<(), String> {
    const WHY: &str = "the password must not go to somebody unknown";
    if !arguments.rws.starts_with("https:") {
        let error = client(arguments, "").err();
        if let Some(error) = error {
            report.refused(Step::Certificate, &error);
            return Err(WHY.to_owned());
        }
        report.skipped(
            Step::Certificate,
            "plain HTTP has none; everybody on the network can read the password",
        );
        return Ok(());
    }
    let seen = match rws::read_fingerprint(&arguments.rws, ANSWER_WITHIN).await {
        Ok(seen) => seen,
        Err(error) => {
            report.failed(
                Step::Certificate,
                error.to_string(),
                "Check that the port speaks HTTPS; Robot Web Services do so on port 443 by default.",
            );
            return Err(WHY.to_owned());
        }
    };
    let pinned = match &arguments.certificate {
        None => None,
        Some(text) => match text.parse::<rws::Fingerprint>() {
            Ok(pinned) => Some(pinned),
            Err(error) => {
                report.failed(
                    Step::Certificate,
                    format!("--certificate: {error}"),
                    format!("The controller shows {seen}."),
                );
                return Err(WHY.to_owned());
            }
        },
    };
    let error = match pinned {
        Some(pinned) if pinned == seen => {
            report.ok(Step::Certificate, format!("its fingerprint is {seen}"));
            return Ok(());
        }
        Some(pinned) => RwsError::WrongCertificate {
            url: arguments.rws.clone(),
            seen,
            pinned,
        },
        // Some companies sign their controllers' certificates; then the system knows them.
        None => match anonymous_request(arguments).await {
            Ok(()) => {
                report.ok(
                    Step::Certificate,
                    format!("this computer's authorities signed it; its fingerprint is {seen}"),
                );
                return Ok(());
            }
            Err(error) => error,
        },
    };
    report.refused(Step::Certificate, &error);
    Err(WHY.to_owned())
}

/// Asks without a password, so that only the certificate decides.
async fn anonymous_request(arguments: &Args) -> Result<(), RwsError> {
    let nobody = Args {
        user: String::new(),
        ..arguments.clone()
    };
    match client(&nobody, "")?.controller_state().await {
        Ok(_) | Err(RwsError::Unauthorized { .. }) => Ok(()),
        Err(error) => Err(error),
    }
}

/// Opens the session that everything else uses.
pub async fn log_in(
    arguments: &Args,
    password: &str,
    report: &mut Report,
) -> Result<Client, String> {
    let opened = async {
        let client = client(arguments, password)?;
        client.controller_state().await.map(|_| client)
    };
    match opened.await {
        Ok(client) => {
            report.ok(Step::LogIn, format!("as \"{}\"", arguments.user));
            Ok(client)
        }
        Err(error @ RwsError::Unauthorized { .. }) => {
            report.failed(
                Step::LogIn,
                error.to_string(),
                "Check --user and the file after --password-file, and in the controller's user settings that this account exists and may use Robot Web Services.",
            );
            Err("the controller does not let us in".to_owned())
        }
        Err(error) => {
            report.refused(Step::LogIn, &error);
            Err("the controller does not let us in".to_owned())
        }
    }
}

/// After an interruption in the middle of `--move-arm`: the arm stiff, the program stopped.
pub async fn make_safe(arguments: &Args, password: &str) {
    let Ok(client) = client(arguments, password) else {
        return;
    };
    // Each is tried, whatever became of the one before.
    client.stop_execution().await.ok();
    client.set_lead_through(false).await.ok();
    client.set_motors(false).await.ok();
    client.logout().await.ok();
}

#[cfg(test)]
mod tests {
    use super::authority;

    #[test]
    fn an_address_without_a_port_has_the_one_of_its_scheme() {
        let cases = [
            ("https://192.168.125.1", Some("192.168.125.1:443")),
            ("http://robot/", Some("robot:80")),
            ("https://robot:8443/x", Some("robot:8443")),
            ("https://[fe80::1]", Some("[fe80::1]:443")),
            ("https://[fe80::1]:8443", Some("[fe80::1]:8443")),
            ("192.168.125.1", None),
            ("https://", None),
            ("ftp://robot", None),
        ];
        for (url, expected) in cases {
            assert_eq!(authority(url).as_deref(), expected, "{url}");
        }
    }
}
