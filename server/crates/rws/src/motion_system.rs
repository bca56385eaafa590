//! Where the arm is.

use crate::hal::Entries;
use crate::{Client, RwsError};

impl Client {
    /// Reads the measured joint angles of `ROB_1` in degrees, axis 1 to 6.
    ///
    /// # Errors
    /// [`RwsError::Unreadable`] when an axis is missing or not a finite number.
    pub async fn joint_target_deg(&self) -> Result<[f64; 6], RwsError> {
        let path = "/rw/motionsystem/mechunits/ROB_1/jointtarget";
        let text = self.get(path).await?;
        let entries = Entries::parse(path, &text)?;
        let entry = entries.with_field("rax_1")?;
        let mut joints_deg = [0.0; 6];
        for (joint, axis) in joints_deg
            .iter_mut()
            .zip(["rax_1", "rax_2", "rax_3", "rax_4", "rax_5", "rax_6"])
        {
            *joint = entry.number(axis)?;
        }
        Ok(joints_deg)
    }
}
