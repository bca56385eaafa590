//! Encoding and decoding of whole messages, for programs that may allocate.
//!
//! The control loop uses [`crate::wire`] instead.

use prost::Message;

use crate::error::Error;
use crate::messages::{EgmJoints, EgmPose, EgmRobot, EgmSensor};

/// Decodes a controller's message.
///
/// # Errors
/// [`Error::Decode`] when the bytes are no such message.
pub fn decode_robot(datagram: &[u8]) -> Result<EgmRobot, Error> {
    Ok(EgmRobot::decode(datagram)?)
}

/// Decodes a sensor's message, that is, one of ours.
///
/// # Errors
/// [`Error::Decode`] when the bytes are no such message.
pub fn decode_sensor(datagram: &[u8]) -> Result<EgmSensor, Error> {
    Ok(EgmSensor::decode(datagram)?)
}

/// Encodes a controller's message into `out`, replacing what it held.
///
/// # Errors
/// [`Error::NotFinite`] when a position is not a finite number; `out` is then empty.
pub fn encode_robot(message: &EgmRobot, out: &mut Vec<u8>) -> Result<(), Error> {
    out.clear();
    if let Some(feed_back) = &message.feed_back {
        check_joints("feedBack.joints", feed_back.joints.as_ref())?;
        check_pose("feedBack.cartesian", feed_back.cartesian.as_ref())?;
        check_joints(
            "feedBack.externalJoints",
            feed_back.external_joints.as_ref(),
        )?;
    }
    if let Some(planned) = &message.planned {
        check_joints("planned.joints", planned.joints.as_ref())?;
        check_pose("planned.cartesian", planned.cartesian.as_ref())?;
        check_joints("planned.externalJoints", planned.external_joints.as_ref())?;
    }
    check("utilizationRate", message.utilization_rate.iter())?;
    if let Some(force) = &message.measured_force {
        check("measuredForce", force.values())?;
    }
    check_joints("torqueRef", message.torque_ref.as_ref())?;
    append(message, out);
    Ok(())
}

/// Encodes a sensor's message into `out`, replacing what it held.
///
/// # Errors
/// [`Error::NotFinite`] when a reference is not a finite number; `out` is then empty.
pub fn encode_sensor(message: &EgmSensor, out: &mut Vec<u8>) -> Result<(), Error> {
    out.clear();
    if let Some(planned) = &message.planned {
        check_joints("planned.joints", planned.joints.as_ref())?;
        check_pose("planned.cartesian", planned.cartesian.as_ref())?;
        check_joints("planned.externalJoints", planned.external_joints.as_ref())?;
    }
    if let Some(speed) = &message.speed_ref {
        check_joints("speedRef.joints", speed.joints.as_ref())?;
        check_joints("speedRef.externalJoints", speed.external_joints.as_ref())?;
        if let Some(cartesians) = &speed.cartesians {
            check("speedRef.cartesians", &cartesians.value)?;
        }
    }
    if let Some(data) = &message.rapid_to_robot {
        check("RAPIDtoRobot.dnum", &data.dnum)?;
    }
    append(message, out);
    Ok(())
}

fn append(message: &impl Message, out: &mut Vec<u8>) {
    out.reserve(message.encoded_len());
    message.encode_raw(out);
}

fn check<'a>(field: &'static str, values: impl IntoIterator<Item = &'a f64>) -> Result<(), Error> {
    if values.into_iter().all(|value| value.is_finite()) {
        Ok(())
    } else {
        Err(Error::NotFinite { field })
    }
}

fn check_joints(field: &'static str, joints: Option<&EgmJoints>) -> Result<(), Error> {
    joints.map_or(Ok(()), |joints| check(field, &joints.joints))
}

fn check_pose(field: &'static str, pose: Option<&EgmPose>) -> Result<(), Error> {
    let Some(pose) = pose else { return Ok(()) };
    if let Some(p) = pose.pos {
        check(field, &[p.x, p.y, p.z])?;
    }
    if let Some(q) = pose.orient {
        check(field, &[q.u0, q.u1, q.u2, q.u3])?;
    }
    if let Some(e) = pose.euler {
        check(field, &[e.x, e.y, e.z])?;
    }
    Ok(())
}
