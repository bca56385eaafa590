//! The measured force, whose field 1 changed its type between RobotWare 6 and 7.
//!
//! RobotWare 6 sends the six force values as field 1; RobotWare 7 sends there whether force control
//! is active, and the values as field 2. The wire type tells the two apart, which a derived message
//! cannot express.

use prost::bytes::{Buf, BufMut};
use prost::encoding::{DecodeContext, WireType, bool, double, skip_field};
use prost::{DecodeError, Message};

/// Force at the tool, in either layout.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EgmMeasuredForce {
    /// Force control is active (RobotWare 7, field 1).
    pub fc_active: Option<bool>,
    /// The six values as RobotWare 6 sends them (field 1).
    pub force_rw6: Vec<f64>,
    /// The six values as RobotWare 7 sends them (field 2).
    pub force: Vec<f64>,
}

impl EgmMeasuredForce {
    /// The force values, whichever RobotWare sent them.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        if self.force.is_empty() {
            &self.force_rw6
        } else {
            &self.force
        }
    }
}

impl Message for EgmMeasuredForce {
    fn encode_raw(&self, buf: &mut impl BufMut) {
        if let Some(active) = &self.fc_active {
            bool::encode(1, active, buf);
        }
        double::encode_repeated(1, &self.force_rw6, buf);
        double::encode_repeated(2, &self.force, buf);
    }

    fn merge_field(
        &mut self,
        tag: u32,
        wire_type: WireType,
        buf: &mut impl Buf,
        ctx: DecodeContext,
    ) -> Result<(), DecodeError> {
        match (tag, wire_type) {
            (1, WireType::Varint) => {
                bool::merge(wire_type, self.fc_active.get_or_insert(false), buf, ctx)
            }
            (1, _) => double::merge_repeated(wire_type, &mut self.force_rw6, buf, ctx),
            (2, _) => double::merge_repeated(wire_type, &mut self.force, buf, ctx),
            _ => skip_field(wire_type, tag, buf, ctx),
        }
    }

    fn encoded_len(&self) -> usize {
        self.fc_active
            .map_or(0, |active| bool::encoded_len(1, &active))
            + double::encoded_len_repeated(1, &self.force_rw6)
            + double::encoded_len_repeated(2, &self.force)
    }

    fn clear(&mut self) {
        *self = Self::default();
    }
}
