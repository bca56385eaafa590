//! What the controller's event numbers mean for the person at the arm, and what to do.
//!
//! The numbers are those that hand guiding and guided motion meet. Any other event is shown with
//! the controller's own title, and with advice that fits its log domain.

/// An event in plain words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Explanation {
    /// What happened.
    pub what: &'static str,
    /// What to do.
    pub advice: &'static str,
}

const EXPLANATIONS: [(u32, Explanation); 20] = [
    (
        10_012,
        Explanation {
            what: "a guard stopped the arm",
            advice: "Close the door or leave the guarded area, then acknowledge the stop.",
        },
    ),
    (
        10_013,
        Explanation {
            what: "an emergency stop was pressed",
            advice: "Make sure nobody is in danger, release the button, then acknowledge it on the FlexPendant.",
        },
    ),
    (
        10_014,
        Explanation {
            what: "the controller has failed",
            advice: "Read the controller's log on the FlexPendant and restart the controller.",
        },
    ),
    (
        10_015,
        Explanation {
            what: "the controller was switched to manual mode",
            advice: "Switch it back to automatic when nobody works in the arm's area.",
        },
    ),
    (
        10_020,
        Explanation {
            what: "the robot program stopped with an error",
            advice: "Read the entries before this one; they say why.",
        },
    ),
    (
        20_205,
        Explanation {
            what: "the automatic-mode stop is open",
            advice: "Close the door or leave the guarded area, then acknowledge the stop.",
        },
    ),
    (
        40_160,
        Explanation {
            what: "the robot program has errors",
            advice: "Ask whoever set up the cell to load TEAM's robot modules again and check them.",
        },
    ),
    (
        41_822,
        Explanation {
            what: "the controller got no motion data from TEAM in time",
            advice: "Check that TEAM runs, and the network cable and firewall between it and the controller. Run team doctor.",
        },
    ),
    (
        41_826,
        Explanation {
            what: "the robot program mixes two kinds of guided motion",
            advice: "Ask whoever set up the cell to load TEAM's robot modules again.",
        },
    ),
    (
        41_830,
        Explanation {
            what: "TEAM was not listening when the controller sent to it",
            advice: "Start TEAM before the robot program. If it runs, check the address and port of the controller's UDPUC device.",
        },
    ),
    (
        50_026,
        Explanation {
            what: "the arm came too close to a stretched wrist or elbow",
            advice: "Move the arm out of this pose by hand and teach the motion with more bend in the wrist.",
        },
    ),
    (
        50_027,
        Explanation {
            what: "a joint came to the end of its range",
            advice: "Move the joint back by hand and teach the motion farther from the end of its range.",
        },
    ),
    (
        50_050,
        Explanation {
            what: "the motion leads out of the arm's reach",
            advice: "Teach the motion closer to the arm.",
        },
    ),
    (
        50_056,
        Explanation {
            what: "a joint needed more force than it should: something held the arm",
            advice: "Look for what the arm touched, free it, and check the tool's weight in the controller.",
        },
    ),
    (
        50_204,
        Explanation {
            what: "the arm touched something, or its tool is heavier than the controller knows",
            advice: "Look for what the arm touched, free it, and check the tool's weight in the controller.",
        },
    ),
    (
        50_452,
        Explanation {
            what: "guided motion was interrupted in the controller",
            advice: "Start the motion again. If it stays, ask whoever set up the cell.",
        },
    ),
    (
        50_453,
        Explanation {
            what: "the controller refused the motion: it leads out of a joint's range or the arm's reach",
            advice: "Preview the motion again from where the arm stands; teach it farther from the ends of the joints.",
        },
    ),
    (
        50_501,
        Explanation {
            what: "the arm was asked for movements too short to plan",
            advice: "Start the motion again. If it stays, ask whoever set up the cell.",
        },
    ),
    (
        90_515,
        Explanation {
            what: "the arm was moved faster than its safety settings allow",
            advice: "Guide the arm more slowly. After a restart of the controller, jog the arm once in manual mode.",
        },
    ),
    (
        90_543,
        Explanation {
            what: "the controller wants its brakes checked",
            advice: "Run the brake check on the FlexPendant.",
        },
    ),
];

/// The event `code` in plain words, if it is one that this client knows.
#[must_use]
pub fn explain(code: u32) -> Option<Explanation> {
    EXPLANATIONS
        .iter()
        .find(|(known, _)| *known == code)
        .map(|(_, explanation)| *explanation)
}

/// What to do about the event `code`, known or not.
#[must_use]
pub(crate) fn advice(code: u32) -> &'static str {
    match (explain(code), code / 10_000) {
        (Some(explanation), _) => explanation.advice,
        (None, 3) => "Call whoever maintains the robot: it is about its hardware.",
        (None, 4) => "Ask whoever set up the cell: it is about the robot program.",
        (None, 5) => "Look whether the arm touched something, then try again.",
        (None, 9) => "The robot's safety controller stopped the arm. Look why before you go on.",
        (None, _) => "Read the entry on the FlexPendant; it says more.",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_is_explained_once_in_a_sentence_without_jargon() {
        for (place, (code, words)) in EXPLANATIONS.iter().enumerate() {
            let twice = EXPLANATIONS[place + 1..]
                .iter()
                .any(|(other, _)| other == code);
            assert!(!twice, "{code}");
            for jargon in ["EGM", "RAPID", "ERR_", "UAS"] {
                assert!(!words.what.contains(jargon), "{code}: {}", words.what);
            }
            assert!(words.advice.ends_with('.'), "{code}: {}", words.advice);
        }
    }

    #[test]
    fn an_unknown_event_gets_the_advice_of_its_domain() {
        assert_eq!(explain(90_001), None);
        assert!(advice(90_001).contains("safety controller"));
        assert!(advice(41_822).contains("team doctor"));
    }
}
