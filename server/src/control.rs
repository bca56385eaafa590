//! Who controls a robot: of several phones at one arm only one may make it move, the others see
//! who and can ask. Stopping is for everybody, always, and is not in here.
//!
//! A phone comes to control a free robot by using it. It gives control up by saying so, by leaving
//! while the arm rests, or by not using it for a while. A client that names no phone (a line
//! system) never holds a robot, and is refused while a phone does. This keeps people out of each
//! other's way; it is no protection against somebody who means harm.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use serde::Serialize;
use utoipa::ToSchema;

/// A resting arm that its phone has not used for this long is free.
const IDLE: Duration = Duration::from_secs(120);
/// Who asks gets a resting arm after this time when nobody answers.
const PATIENCE: Duration = Duration::from_secs(20);

/// A phone as it names itself.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, ToSchema)]
pub struct Phone {
    /// Made by the phone once, and kept.
    pub id: String,
    /// What people call it.
    pub name: String,
}

/// Who controls a robot.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, ToSchema)]
pub struct ControlView {
    /// The phone that may make the arm move.
    pub phone: Phone,
    /// A phone that asks for it.
    pub asked_by: Option<Phone>,
}

/// Why a phone may not.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ControlError {
    /// Another phone has the robot.
    #[error("{name} controls this robot")]
    Controlled {
        /// What people call that phone.
        name: String,
    },
    /// Only who controls the robot can give it away.
    #[error("this phone does not control the robot")]
    NotYours,
    /// The client named no phone.
    #[error("only a phone can control a robot")]
    NoPhone,
}

impl ControlError {
    /// A stable name for programs.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Controlled { .. } => "robot_controlled",
            Self::NotYours => "not_in_control",
            Self::NoPhone => "phone_missing",
        }
    }

    /// What to do.
    pub fn advice(&self) -> &'static str {
        match self {
            Self::Controlled { .. } => "Ask for control of the robot, or wait until it is free.",
            Self::NotYours => "Ask for control of the robot first.",
            Self::NoPhone => "Use the app on a phone.",
        }
    }
}

/// The control of one robot. Cheap to clone.
#[derive(Clone, Debug, Default)]
pub struct Control(Arc<Mutex<Inner>>);

#[derive(Debug, Default)]
struct Inner {
    holder: Option<Since>,
    asked: Option<Since>,
    /// How many live sockets each phone has.
    watching: HashMap<String, usize>,
}

#[derive(Clone, Debug)]
struct Since {
    phone: Phone,
    at: Instant,
}

/// As long as this lives, the phone watches the robot.
#[derive(Debug)]
pub struct Watching {
    control: Control,
    id: String,
}

impl Drop for Watching {
    fn drop(&mut self) {
        let mut inner = self.control.lock();
        if let Some(count) = inner.watching.get_mut(&self.id) {
            *count -= 1;
            if *count == 0 {
                inner.watching.remove(&self.id);
            }
        }
    }
}

/// When something happens, and whether the arm is in use at that moment: guided, moving, or coming
/// to rest.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    /// The time.
    pub now: Instant,
    /// Whether the arm is in use.
    pub in_use: bool,
}

impl Control {
    /// A phone begins to watch.
    pub fn watch(&self, phone: &Phone) -> Watching {
        *self.lock().watching.entry(phone.id.clone()).or_default() += 1;
        Watching {
            control: self.clone(),
            id: phone.id.clone(),
        }
    }

    /// Something is about to make the arm move: the phone controls the robot from now on.
    ///
    /// # Errors
    /// When another phone does.
    pub fn claim(&self, phone: Option<&Phone>, moment: Moment) -> Result<(), ControlError> {
        let mut inner = self.lock();
        inner.settle(moment);
        inner.check_free_for(phone)?;
        if let Some(phone) = phone {
            inner.hand_to(phone.clone(), moment.now);
        }
        Ok(())
    }

    /// Asks for the robot; a free one is had at once.
    pub fn ask(&self, phone: &Phone, moment: Moment) {
        let mut inner = self.lock();
        inner.settle(moment);
        if inner.check_free_for(Some(phone)).is_ok() {
            inner.hand_to(phone.clone(), moment.now);
        } else {
            inner.asked = Some(Since {
                phone: phone.clone(),
                at: moment.now,
            });
        }
    }

    /// The holder answers: the robot goes to who asked, or stays.
    ///
    /// # Errors
    /// When the phone is not the holder.
    pub fn answer(&self, phone: &Phone, gives: bool, moment: Moment) -> Result<(), ControlError> {
        let mut inner = self.lock();
        inner.settle(moment);
        inner.check_holds(phone)?;
        match inner.asked.take() {
            Some(asked) if gives => inner.hand_to(asked.phone, moment.now),
            _ => inner.hand_to(phone.clone(), moment.now),
        }
        Ok(())
    }

    /// The holder needs the robot no more.
    ///
    /// # Errors
    /// When the phone is not the holder.
    pub fn release(&self, phone: &Phone, moment: Moment) -> Result<(), ControlError> {
        let mut inner = self.lock();
        inner.settle(moment);
        inner.check_holds(phone)?;
        inner.holder = None;
        inner.settle(moment);
        Ok(())
    }

    /// Who controls the robot; nothing when it is free.
    pub fn view(&self, moment: Moment) -> Option<ControlView> {
        let mut inner = self.lock();
        inner.settle(moment);
        inner.holder.as_ref().map(|holder| ControlView {
            phone: holder.phone.clone(),
            asked_by: inner.asked.as_ref().map(|asked| asked.phone.clone()),
        })
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Inner> {
        // Every change is whole before anything in it can panic.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Inner {
    fn hand_to(&mut self, phone: Phone, at: Instant) {
        self.asked = self.asked.take().filter(|asked| asked.phone.id != phone.id);
        self.holder = Some(Since { phone, at });
    }

    fn check_free_for(&self, phone: Option<&Phone>) -> Result<(), ControlError> {
        match &self.holder {
            Some(holder) if phone.map(|phone| &phone.id) != Some(&holder.phone.id) => {
                Err(ControlError::Controlled {
                    name: holder.phone.name.clone(),
                })
            }
            _ => Ok(()),
        }
    }

    fn check_holds(&self, phone: &Phone) -> Result<(), ControlError> {
        let holder = self.holder.as_ref();
        if holder.is_some_and(|holder| holder.phone.id == phone.id) {
            Ok(())
        } else {
            Err(ControlError::NotYours)
        }
    }

    /// What time alone has changed.
    fn settle(&mut self, Moment { now, in_use }: Moment) {
        let gone = |watching: &HashMap<_, _>, phone: &Phone| !watching.contains_key(&phone.id);
        if self
            .asked
            .as_ref()
            .is_some_and(|asked| gone(&self.watching, &asked.phone))
        {
            self.asked = None;
        }
        if in_use {
            // From when it rests again its holder has the whole time.
            if let Some(holder) = &mut self.holder {
                holder.at = now;
            }
            return;
        }
        let is_over = |holder: &Since| {
            gone(&self.watching, &holder.phone) || now.duration_since(holder.at) > IDLE
        };
        if self.holder.as_ref().is_some_and(is_over) {
            self.holder = None;
        }
        let waited = |asked: &Since| now.duration_since(asked.at) > PATIENCE;
        if (self.holder.is_none() || self.asked.as_ref().is_some_and(waited))
            && let Some(asked) = self.asked.take()
        {
            self.hand_to(asked.phone, now);
        }
    }
}

#[cfg(test)]
mod tests;
