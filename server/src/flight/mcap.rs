//! A flight record as an MCAP file (<https://mcap.dev/spec>) with JSON messages.
//!
//! Joints are written as `foxglove.JointStates` and events as `foxglove.Log`, which viewers know by
//! name; the first one wants radians. The topics are described in `docs/flight.md`. Nothing is
//! compressed: compression would bring C libraries into the build.

use std::collections::BTreeMap;
use std::io::Write;
use std::sync::{Arc, Mutex, PoisonError};

use ::mcap::records::{MessageHeader, Metadata};
use ::mcap::write::{NoSeek, Writer};
use ::mcap::{McapError, WriteOptions};
use motion::kinematics::radians;
use serde::Serialize;
use serde_json::json;

use super::ExportError;
use crate::store::cycles::{Cycle, CyclePhase};
use crate::store::flights::FlightEvent;
use crate::store::reproductions::Reproduction;

/// Messages of about two seconds of a record in one chunk.
const CHUNK_BYTES: u64 = 512 * 1024;
const NAMES: [&str; 6] = [
    "joint_1", "joint_2", "joint_3", "joint_4", "joint_5", "joint_6",
];

/// Turns cycles and events into the bytes of a file, piece by piece.
pub(super) struct Recorder {
    bytes: Bytes,
    writer: Writer<NoSeek<Bytes>>,
    channels: Channels,
    began_ns: u64,
    sequence: u32,
    events: std::iter::Peekable<std::vec::IntoIter<FlightEvent>>,
}

struct Channels {
    commanded: u16,
    measured: u16,
    cycle: u16,
    events: u16,
}

#[derive(Serialize)]
struct JointStates {
    timestamp: Time,
    joints: [JointState; 6],
}

#[derive(Serialize)]
struct JointState {
    name: &'static str,
    position: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    velocity: Option<f64>,
}

#[derive(Serialize)]
struct CycleFacts {
    timestamp: Time,
    t_s: f64,
    plan_t_s: f64,
    phase: CyclePhase,
    lost: u32,
    late: bool,
    held: bool,
    limited: bool,
    motors_on: bool,
    rapid_running: bool,
    utilization_percent: Option<f32>,
}

#[derive(Serialize)]
struct Log<'a> {
    timestamp: Time,
    /// 2 is "info".
    level: u8,
    message: &'a str,
    name: &'a str,
    file: &'static str,
    line: u32,
}

#[derive(Clone, Copy, Serialize)]
struct Time {
    sec: u64,
    nsec: u32,
}

impl Time {
    fn from_ns(ns: u64) -> Self {
        Self {
            sec: ns / 1_000_000_000,
            nsec: (ns % 1_000_000_000) as u32,
        }
    }
}

impl Recorder {
    pub(super) fn new(
        reproduction: &Reproduction,
        events: Vec<FlightEvent>,
    ) -> Result<Self, ExportError> {
        let bytes = Bytes::default();
        let mut writer = WriteOptions::new()
            .compression(None)
            .disable_seeking(true)
            .chunk_size(Some(CHUNK_BYTES))
            .library("team")
            .create(NoSeek::new(bytes.clone()))?;
        let channels = Channels::add(&mut writer)?;
        writer.write_metadata(&Metadata {
            name: "reproduction".into(),
            metadata: BTreeMap::from([
                ("id".into(), reproduction.id.to_string()),
                ("task_id".into(), reproduction.task_id.to_string()),
                ("model_id".into(), reproduction.model_id.to_string()),
                ("plan".into(), reproduction.plan.clone()),
                ("state".into(), reproduction.state.as_str().into()),
                (
                    "reason".into(),
                    reproduction.reason.clone().unwrap_or_default(),
                ),
            ]),
        })?;
        let began = reproduction.armed_at.unwrap_or(reproduction.created_at);
        Ok(Self {
            bytes,
            writer,
            channels,
            began_ns: u64::try_from(began.0).unwrap_or(0) * 1_000_000,
            sequence: 0,
            events: events.into_iter().peekable(),
        })
    }

    pub(super) fn write(&mut self, cycles: &[Cycle]) -> Result<Vec<u8>, ExportError> {
        for cycle in cycles {
            while let Some(event) = self.events.next_if(|event| event.at_us <= cycle.at_us) {
                self.event(&event)?;
            }
            self.cycle(cycle)?;
        }
        Ok(self.bytes.take())
    }

    pub(super) fn finish(&mut self) -> Result<Vec<u8>, ExportError> {
        while let Some(event) = self.events.next() {
            self.event(&event)?;
        }
        self.writer.finish()?;
        Ok(self.bytes.take())
    }

    fn cycle(&mut self, cycle: &Cycle) -> Result<(), ExportError> {
        let ns = self.ns(cycle.at_us);
        let timestamp = Time::from_ns(ns);
        let speeds = cycle.details.map(|details| details.commanded_deg_s);
        let commanded = JointStates {
            timestamp,
            joints: std::array::from_fn(|joint| JointState {
                name: NAMES[joint],
                position: radians(cycle.commanded_deg[joint]),
                velocity: speeds.map(|speeds| radians(f64::from(speeds[joint]))),
            }),
        };
        self.message(self.channels.commanded, ns, &commanded)?;
        let measured = JointStates {
            timestamp,
            joints: std::array::from_fn(|joint| JointState {
                name: NAMES[joint],
                position: radians(cycle.measured_deg[joint]),
                velocity: None,
            }),
        };
        self.message(self.channels.measured, ns, &measured)?;
        if let Some(details) = cycle.details {
            let facts = CycleFacts {
                timestamp,
                t_s: cycle.at_us as f64 / 1e6,
                plan_t_s: cycle.plan_t_s,
                phase: details.phase,
                lost: details.lost,
                late: details.late,
                held: details.held,
                limited: details.limited,
                motors_on: details.motors_on,
                rapid_running: details.rapid_running,
                utilization_percent: details.utilization_percent,
            };
            self.message(self.channels.cycle, ns, &facts)?;
        }
        self.sequence = self.sequence.wrapping_add(1);
        Ok(())
    }

    fn event(&mut self, event: &FlightEvent) -> Result<(), ExportError> {
        let ns = self.ns(event.at_us);
        let log = Log {
            timestamp: Time::from_ns(ns),
            level: 2,
            message: &event.message,
            name: &event.code,
            file: "",
            line: 0,
        };
        self.message(self.channels.events, ns, &log)
    }

    fn ns(&self, at_us: u64) -> u64 {
        self.began_ns.saturating_add(at_us.saturating_mul(1_000))
    }

    fn message(
        &mut self,
        channel_id: u16,
        ns: u64,
        body: &impl Serialize,
    ) -> Result<(), ExportError> {
        let header = MessageHeader {
            channel_id,
            sequence: self.sequence,
            log_time: ns,
            publish_time: ns,
        };
        let json = serde_json::to_vec(body).map_err(std::io::Error::from);
        let json = json.map_err(McapError::from)?;
        self.writer.write_to_known_channel(&header, &json)?;
        Ok(())
    }
}

impl Channels {
    fn add(writer: &mut Writer<NoSeek<Bytes>>) -> Result<Self, McapError> {
        let mut schema = |name: &str, properties: serde_json::Value| {
            let schema = json!({ "title": name, "type": "object", "properties": properties });
            writer.add_schema(name, "jsonschema", schema.to_string().as_bytes())
        };
        let time = json!({
            "type": "object", "title": "time",
            "properties": { "sec": { "type": "integer" }, "nsec": { "type": "integer" } },
        });
        let number = json!({ "type": "number" });
        let joint = json!({ "type": "object", "properties": {
            "name": { "type": "string" }, "position": number, "velocity": number,
        } });
        let joints = schema(
            "foxglove.JointStates",
            json!({ "timestamp": time, "joints": { "type": "array", "items": joint } }),
        )?;
        let log = schema(
            "foxglove.Log",
            json!({
                "timestamp": time, "level": { "type": "integer" },
                "message": { "type": "string" }, "name": { "type": "string" },
                "file": { "type": "string" }, "line": { "type": "integer" },
            }),
        )?;
        let flag = json!({ "type": "boolean" });
        let cycle = schema(
            "team.Cycle",
            json!({
                "timestamp": time, "t_s": number, "plan_t_s": number,
                "phase": { "type": "string" }, "lost": { "type": "integer" },
                "late": flag, "held": flag, "limited": flag,
                "motors_on": flag, "rapid_running": flag,
                "utilization_percent": { "type": ["number", "null"] },
            }),
        )?;
        let mut channel =
            |schema, topic| writer.add_channel(schema, topic, "json", &BTreeMap::new());
        Ok(Self {
            commanded: channel(joints, "/commanded")?,
            measured: channel(joints, "/measured")?,
            cycle: channel(cycle, "/cycle")?,
            events: channel(log, "/events")?,
        })
    }
}

/// What the writer has written and nobody has taken yet. It is never locked for longer than a copy
/// takes, and only one thread at a time works on a file.
#[derive(Clone, Default)]
struct Bytes(Arc<Mutex<Vec<u8>>>);

impl Bytes {
    fn take(&self) -> Vec<u8> {
        std::mem::take(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Write for Bytes {
    fn write(&mut self, piece: &[u8]) -> std::io::Result<usize> {
        let mut bytes = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        bytes.extend_from_slice(piece);
        Ok(piece.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}
