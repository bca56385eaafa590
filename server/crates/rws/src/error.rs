//! What can go wrong between us and the controller, each with advice for the person at the arm.

use crate::Fingerprint;

/// An answer of the controller, or its absence, that kept a call from doing what it should.
#[derive(Debug, thiserror::Error)]
pub enum RwsError {
    /// The address in the configuration is not an HTTP address.
    #[error("the robot's address \"{url}\" is not usable: {reason}")]
    BadAddress {
        /// As configured.
        url: String,
        /// What the parser says.
        reason: String,
    },
    /// The pinned fingerprint in the configuration is none.
    #[error("the certificate fingerprint \"{text}\" is not usable")]
    BadFingerprint {
        /// As configured.
        text: String,
    },
    /// Nobody has said that this certificate is the controller's.
    #[error(
        "the robot controller at {url} shows a certificate that this computer does not know; its SHA-256 fingerprint is {seen}"
    )]
    UnknownCertificate {
        /// Base address of the controller.
        url: String,
        /// The certificate's fingerprint.
        seen: Fingerprint,
    },
    /// Another certificate than the pinned one.
    #[error(
        "the robot controller at {url} shows another certificate than the configured one: its SHA-256 fingerprint is {seen}, configured is {pinned}"
    )]
    WrongCertificate {
        /// Base address of the controller.
        url: String,
        /// The fingerprint of the certificate that it showed.
        seen: Fingerprint,
        /// The fingerprint in the configuration.
        pinned: Fingerprint,
    },
    /// No answer: no connection, or none in time.
    #[error("the robot controller at {url} does not answer: {reason}")]
    Unreachable {
        /// Base address of the controller.
        url: String,
        /// The transport's words.
        reason: String,
    },
    /// The user name or the password was refused, also after a fresh log-in.
    #[error("the robot controller refuses the user \"{user}\"")]
    Unauthorized {
        /// The account that was tried.
        user: String,
    },
    /// 503 on every attempt: the controller's session pool is exhausted or it is overloaded.
    #[error("the robot controller is too busy to answer ({path})")]
    Busy {
        /// The resource.
        path: String,
    },
    /// The controller understood and said no.
    #[error("the robot controller refuses {path}: {message}")]
    Refused {
        /// The resource.
        path: String,
        /// HTTP status.
        status: u16,
        /// ABB's return code, if the answer held one.
        code: Option<i64>,
        /// ABB's words, if any.
        message: String,
    },
    /// The resource does not exist on this controller.
    #[error("the robot controller has no resource {path}")]
    Missing {
        /// The resource.
        path: String,
    },
    /// Any other status.
    #[error("the robot controller answered {status} to {path}: {message}")]
    Unexpected {
        /// The resource.
        path: String,
        /// HTTP status.
        status: u16,
        /// ABB's words, if any.
        message: String,
    },
    /// The answer could not be understood.
    #[error("the robot controller's answer to {path} is not readable: {reason}")]
    Unreadable {
        /// The resource.
        path: String,
        /// What is wrong with it.
        reason: String,
    },
    /// Lead-through was accepted, but the controller did not keep it.
    #[error("{}", not_switched(*.active, .reason))]
    LeadThroughReverted {
        /// What had been asked for.
        active: bool,
        /// New messages of the safety log, or a general sentence.
        reason: String,
    },
    /// RAPID was told to start or stop, and did not within the time the controller needs for it.
    #[error("{}", if *.running { "the robot program did not start" } else { "the robot program did not stop" })]
    ExecutionUnchanged {
        /// What had been asked for.
        running: bool,
    },
}

impl RwsError {
    /// A stable word for machines.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::BadAddress { .. } => "robot_address",
            Self::BadFingerprint { .. } => "robot_fingerprint",
            Self::UnknownCertificate { .. } => "robot_certificate_unknown",
            Self::WrongCertificate { .. } => "robot_certificate_wrong",
            Self::Unreachable { .. } => "robot_unreachable",
            Self::Unauthorized { .. } => "robot_login",
            Self::Busy { .. } => "robot_overloaded",
            Self::Refused { .. } => "robot_refused",
            Self::Missing { .. } => "robot_resource_missing",
            Self::Unexpected { .. } => "robot_unexpected_answer",
            Self::Unreadable { .. } => "robot_unreadable_answer",
            Self::LeadThroughReverted { .. } => "lead_through_reverted",
            Self::ExecutionUnchanged { .. } => "robot_program",
        }
    }

    /// What a person can do about it.
    #[must_use]
    pub fn advice(&self) -> &'static str {
        match self {
            Self::BadAddress { .. } => {
                "Write the address as https://192.168.125.1 in the configuration."
            }
            Self::BadFingerprint { .. } => {
                "Write rws_certificate_sha256 as 64 hexadecimal digits, as team doctor shows them; colons between them do not matter."
            }
            Self::UnknownCertificate { .. } => {
                "Compare the fingerprint with the one that team doctor shows on a computer plugged into the controller's service port. If it is the same, set it as rws_certificate_sha256 in the configuration."
            }
            Self::WrongCertificate { .. } => {
                "If the controller was replaced or installed anew, compare its fingerprint at the controller's service port and set it as rws_certificate_sha256. Otherwise another device answers at the robot's address: call whoever runs the network."
            }
            Self::Unreachable { .. } => {
                "Check that the controller is switched on and its network cable is plugged in."
            }
            Self::Unauthorized { .. } => {
                "Check the robot's user name and password in the configuration."
            }
            Self::Busy { .. } => {
                "Wait a moment. If it stays, close other programs that talk to the robot."
            }
            Self::Refused { code, message, .. } => refusal_advice(*code, message),
            Self::Missing { .. } => {
                "Check that the robot program and the controller options match the installation notes."
            }
            Self::Unexpected { .. } | Self::Unreadable { .. } => {
                "Try again. If it stays, the controller's software may be of another generation than RobotWare 7."
            }
            Self::LeadThroughReverted { active: true, .. } => {
                "Do not push the arm while it lets go. Check for a safety stop, then try again. After a restart, jog the arm once in manual mode."
            }
            Self::LeadThroughReverted { active: false, .. } => {
                "Let go of the arm, keep clear of it and try again."
            }
            Self::ExecutionUnchanged { .. } => {
                "Check that the controller is in automatic mode and that the robot program has no errors."
            }
        }
    }

    /// Whether the controller cannot be reached at all, as opposed to having said something.
    #[must_use]
    pub fn is_unreachable(&self) -> bool {
        matches!(self, Self::Unreachable { .. })
    }
}

fn not_switched(active: bool, reason: &str) -> String {
    if active {
        format!("the robot did not let go of the arm: {reason}")
    } else {
        format!("the robot did not take hold of the arm again: {reason}")
    }
}

/// ABB's return codes that a worker can do something about.
fn refusal_advice(code: Option<i64>, message: &str) -> &'static str {
    const HELD_BY_SOMEONE_ELSE: i64 = -1_073_445_862;
    const NO_GRANT: i64 = -757;
    const SIGNAL_REJECTED: i64 = -1_073_445_881;
    const WRONG_RAPID_STATE: i64 = -1_073_442_809;
    match code {
        Some(HELD_BY_SOMEONE_ELSE) => {
            "Another program or the FlexPendant holds the controller. Log off there, then try again."
        }
        Some(NO_GRANT) => "The robot's user account lacks this right. Ask whoever set up the cell.",
        Some(SIGNAL_REJECTED) => {
            "The signal may not be written from outside. Set its access level to All."
        }
        Some(WRONG_RAPID_STATE) => "Stop the robot program on the FlexPendant, then try again.",
        _ if message.contains("mastership") => {
            "Another program or the FlexPendant holds the controller. Log off there, then try again."
        }
        _ => {
            "Check on the FlexPendant that the controller is in automatic mode and not stopped by a guard."
        }
    }
}
