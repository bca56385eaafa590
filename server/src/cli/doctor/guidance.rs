//! EGM: whether messages arrive, what they look like, and whether our answers are applied.
//!
//! Every answer is the pose in which the arm stood when the session began, at rest.

mod listening;

use std::net::SocketAddr;
use std::time::Duration;

use rws::{Client, Cycle, Execution, RwsError};
use tokio::net::UdpSocket;

use super::Args;
use super::report::{Report, Step};
use listening::{Heard, listen};

/// Log domain of the robot program, where EGM's complaints are, and ABB's numbers for them.
const PROGRAM_DOMAIN: u32 = 4;
const COMPLAINTS: [u32; 3] = [41_822, 41_826, 41_830];
/// More lost messages than one in so many are too many.
const ONE_LOST_IN: u64 = 100;
/// The controller's own time-out is a second: answers that it does not see end the session by then.
const APPLIED_S: f64 = 1.5;
/// What has to be in order before the robot program is started: with another program in the
/// controller than TEAM's, the arm would move.
const NEEDED: [Step; 4] = [Step::Rights, Step::Mode, Step::Motors, Step::Program];
/// An arm that is held may give way by so much.
const STILL_DEG: f64 = 0.5;

/// Listens, with `--move-arm` while the robot program runs.
pub async fn look(client: &Client, listen_at: SocketAddr, arguments: &Args, report: &mut Report) {
    let socket = match UdpSocket::bind(listen_at).await {
        Ok(socket) => socket,
        Err(error) => {
            report.failed(
                Step::EgmPort,
                format!("{listen_at}: {error}"),
                "Stop the TEAM service or whatever else uses the port, and check that the address is one of this computer's.",
            );
            for step in [Step::EgmMessages, Step::EgmAnswers] {
                report.skipped(step, "nothing can arrive at a port that is not ours");
            }
            return;
        }
    };
    report.ok(Step::EgmPort, listen_at.to_string());
    let before = client.execution().await;
    // A program that runs is somebody's; it is listened to, and goes on.
    let ours = arguments.move_arm && matches!(before, Ok(Execution::Stopped));
    if ours && !report.all_ok(&NEEDED) {
        for step in [Step::EgmMessages, Step::EgmAnswers] {
            report.skipped(step, "the robot program is not started before the mode, the motors, the rights and the modules are in order");
        }
        return;
    }
    let started = match ours {
        true => start_program(client).await,
        false => Ok(()),
    };
    let heard = match started {
        Ok(()) => listen(&socket, Duration::from_secs_f64(arguments.egm_wait)).await,
        Err(_) => Heard::default(),
    };
    let complaint = complaint(client).await;
    let running = client.execution().await;
    if ours {
        // Whatever happened, nothing runs afterwards. Only a program that stands already refuses.
        client.stop_execution().await.ok();
        client.set_motors(false).await.ok();
    }
    if let Err(error) = started {
        report.refused(Step::EgmMessages, &error);
        report.skipped(Step::EgmAnswers, "the robot program did not start");
        return;
    }
    let stands = matches!(running, Ok(Execution::Stopped));
    messages(&heard, stands, complaint.as_deref(), arguments, report);
    answers(&heard, complaint.as_deref(), report);
}

/// From its beginning, because a program stopped in the middle keeps an EGM identity.
async fn start_program(client: &Client) -> Result<(), RwsError> {
    client.request_edit_mastership().await?;
    let reset = client.reset_program_pointer().await;
    client.release_edit_mastership().await?;
    reset?;
    client.set_motors(true).await?;
    client.start_execution(Cycle::Once).await
}

/// The newest word of the controller's log, if it is one about EGM.
async fn complaint(client: &Client) -> Option<String> {
    let newest = client
        .events(PROGRAM_DOMAIN, 1)
        .await
        .ok()?
        .into_iter()
        .next()?;
    COMPLAINTS.contains(&newest.code).then(|| {
        let (at, advice) = (&newest.at, newest.advice());
        format!("; the controller's log says at {at}: {newest}. {advice}")
    })
}

fn messages(
    heard: &Heard,
    program_stands: bool,
    complaint: Option<&str>,
    arguments: &Args,
    report: &mut Report,
) {
    let complaint = complaint.unwrap_or_default();
    if heard.messages == 0 {
        let stands = if program_stands {
            "the robot program stands, so the controller sends nothing. Start TEAM_stream on the FlexPendant while the doctor waits, or run the doctor with --move-arm. If nothing comes then: "
        } else {
            ""
        };
        report.failed(
            Step::EgmMessages,
            format!("none in {} s{complaint}", arguments.egm_wait),
            format!("{stands}check the Remote Address and Remote Port Number of the controller's UDPUC device against --egm, restart the controller after changing them, and let UDP through this computer's firewall."),
        );
        return;
    }
    let saw = heard.words();
    if heard.generation().is_none() {
        report.failed(
            Step::EgmMessages,
            saw,
            "The messages lack the arm's position or its time: update RobotWare.",
        );
    } else if heard.lost * ONE_LOST_IN > heard.messages {
        report.failed(
            Step::EgmMessages,
            saw,
            "Use a cable of its own between controller and computer, no Wi-Fi, and no busy switch.",
        );
    } else {
        report.ok(Step::EgmMessages, saw);
    }
}

fn answers(heard: &Heard, complaint: Option<&str>, report: &mut Report) {
    let complaint = complaint.unwrap_or_default();
    let applied = format!(
        "applied for {:.1} s, the arm moved by {:.2}° at most",
        heard.applied_s(),
        heard.moved_deg
    );
    if heard.messages == 0 {
        report.skipped(Step::EgmAnswers, "there was nothing to answer");
    } else if heard.in_error || (heard.was_applied() && heard.applied_s() < APPLIED_S) {
        report.failed(
            Step::EgmAnswers,
            format!("{applied}; then the controller ended the session{complaint}"),
            "The answers must come from the address that the controller sends to: give --egm this computer's address on the robot's network, not 0.0.0.0. Then read the controller's log.",
        );
    } else if !heard.was_applied() {
        report.skipped(
            Step::EgmAnswers,
            "the controller only reports its position at present; whether it applies answers shows when TEAM_guide runs (--move-arm)",
        );
    } else if heard.moved_deg > STILL_DEG {
        report.failed(
            Step::EgmAnswers,
            applied,
            "It should have stood still: check the tool's mass and centre of gravity in the controller.",
        );
    } else {
        report.ok(Step::EgmAnswers, applied);
    }
}
