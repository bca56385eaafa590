//! The controller's signals.

/// Kind of a signal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SignalKind {
    /// Digital input.
    DigitalInput,
    /// Digital output.
    DigitalOutput,
}

impl SignalKind {
    /// As Robot Web Services write it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::DigitalInput => "DI",
            Self::DigitalOutput => "DO",
        }
    }
}

/// A digital signal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signal {
    /// Its name, unique in the controller.
    pub name: &'static str,
    /// Network and device it is on; none for a virtual signal.
    pub place: Option<(&'static str, &'static str)>,
    /// Kind.
    pub kind: SignalKind,
    /// Its access level lets clients write it.
    pub writable: bool,
    /// Value.
    pub on: bool,
}

impl Signal {
    /// The path below `/rw/iosystem/signals/`.
    #[must_use]
    pub fn path(&self) -> String {
        match self.place {
            Some((network, device)) => format!("{network}/{device}/{}", self.name),
            None => self.name.to_owned(),
        }
    }
}

/// Name of the input that ends an EGM run gracefully: the RAPID program has a trap on it.
pub const EGM_STOP: &str = "EgmStop";

/// Name of the output that closes the gripper.
pub const GRIPPER_CLOSE: &str = "GripperClose";

/// All signals.
#[derive(Clone, Debug)]
pub struct Signals(Vec<Signal>);

impl Default for Signals {
    fn default() -> Self {
        let button = |name| Signal {
            name,
            place: Some(("IntBus", "Asi")),
            kind: SignalKind::DigitalInput,
            writable: false,
            on: false,
        };
        let free = |name, kind| Signal {
            name,
            place: None,
            kind,
            writable: true,
            on: false,
        };
        Self(vec![
            button("Asi1Button1"),
            button("Asi1Button2"),
            free(EGM_STOP, SignalKind::DigitalInput),
            free(GRIPPER_CLOSE, SignalKind::DigitalOutput),
        ])
    }
}

impl Signals {
    /// All signals, in the controller's order.
    #[must_use]
    pub fn all(&self) -> &[Signal] {
        &self.0
    }

    /// The signal with this name or path.
    #[must_use]
    pub fn find(&self, path: &str) -> Option<&Signal> {
        self.0
            .iter()
            .find(|signal| signal.name == path || signal.path() == path)
    }

    /// Sets a signal and returns whether that changed it; nothing when there is no such signal.
    pub fn set(&mut self, name: &str, on: bool) -> Option<bool> {
        let signal = self.0.iter_mut().find(|signal| signal.name == name)?;
        let changed = signal.on != on;
        signal.on = on;
        Some(changed)
    }
}
