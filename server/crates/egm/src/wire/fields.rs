//! Splitting protobuf bytes into fields, in place.

use crate::error::Error;

/// Groups inside groups deeper than this are refused; the protocol has none at all.
const MAX_GROUP_DEPTH: u32 = 128;

/// A part of a datagram that is being read; offsets count from the datagram's first byte.
#[derive(Clone, Copy)]
pub(super) struct Fields<'a> {
    datagram: &'a [u8],
    at: usize,
    end: usize,
}

/// The content of one field.
#[derive(Clone, Copy)]
pub(super) enum Value<'a> {
    Varint(u64),
    Double(f64),
    Bytes(Fields<'a>),
    /// A field of 32 bits, or a group: the messages of EGM have neither.
    Other,
}

/// One field: its number, its content and where it begins.
pub(super) struct Field<'a> {
    pub number: u32,
    pub value: Value<'a>,
    at: usize,
}

impl<'a> Field<'a> {
    /// The content as a sub-message.
    pub fn message(&self) -> Result<Fields<'a>, Error> {
        match self.value {
            Value::Bytes(fields) => Ok(fields),
            _ => Err(Error::Malformed { at: self.at }),
        }
    }

    /// The content as an integer.
    pub fn varint(&self) -> Result<u64, Error> {
        match self.value {
            Value::Varint(value) => Ok(value),
            _ => Err(Error::Malformed { at: self.at }),
        }
    }

    /// The content as an integer of 32 bits; higher bits are dropped, as protobuf asks.
    pub fn uint32(&self) -> Result<u32, Error> {
        Ok((self.varint()? & u64::from(u32::MAX)) as u32)
    }

    /// The content as the number of an enumeration.
    pub fn enumeration(&self) -> Result<i32, Error> {
        Ok(self.uint32()?.cast_signed())
    }

    /// The content as a number.
    pub fn double(&self) -> Result<f64, Error> {
        match self.value {
            Value::Double(value) => Ok(value),
            _ => Err(Error::Malformed { at: self.at }),
        }
    }

    /// Hands the numbers of a repeated field, packed or not, to `each`.
    pub fn doubles(&self, mut each: impl FnMut(f64)) -> Result<(), Error> {
        match self.value {
            Value::Double(value) => each(value),
            Value::Bytes(mut packed) => {
                while packed.at < packed.end {
                    each(packed.take_double()?);
                }
            }
            _ => return Err(Error::Malformed { at: self.at }),
        }
        Ok(())
    }
}

impl<'a> Fields<'a> {
    /// All fields of a datagram.
    pub fn of(datagram: &'a [u8]) -> Self {
        Self {
            datagram,
            at: 0,
            end: datagram.len(),
        }
    }

    /// The next field, or nothing at the end.
    pub fn next(&mut self) -> Result<Option<Field<'a>>, Error> {
        if self.at == self.end {
            return Ok(None);
        }
        let at = self.at;
        let (number, wire_type) = self.take_key()?;
        let value = self.take_value(number, wire_type, at, 0)?;
        Ok(Some(Field { number, value, at }))
    }

    fn take_key(&mut self) -> Result<(u32, u8), Error> {
        let at = self.at;
        let key = u32::try_from(self.take_varint()?).map_err(|_| Error::Malformed { at })?;
        match (key >> 3, (key & 7) as u8) {
            (0, _) => Err(Error::Malformed { at }),
            parts => Ok(parts),
        }
    }

    fn take_value(
        &mut self,
        number: u32,
        wire_type: u8,
        at: usize,
        depth: u32,
    ) -> Result<Value<'a>, Error> {
        match wire_type {
            0 => Ok(Value::Varint(self.take_varint()?)),
            1 => Ok(Value::Double(self.take_double()?)),
            2 => {
                let length = self.take_varint()?;
                let start = self.at;
                let length = usize::try_from(length).map_err(|_| Error::Truncated { at })?;
                self.skip(length)?;
                Ok(Value::Bytes(Self {
                    datagram: self.datagram,
                    at: start,
                    end: self.at,
                }))
            }
            3 if depth < MAX_GROUP_DEPTH => {
                self.skip_group(number, depth)?;
                Ok(Value::Other)
            }
            5 => {
                self.skip(4)?;
                Ok(Value::Other)
            }
            _ => Err(Error::Malformed { at }),
        }
    }

    fn skip_group(&mut self, group: u32, depth: u32) -> Result<(), Error> {
        loop {
            let at = self.at;
            let (number, wire_type) = self.take_key()?;
            if wire_type == 4 {
                return if number == group {
                    Ok(())
                } else {
                    Err(Error::Malformed { at })
                };
            }
            self.take_value(number, wire_type, at, depth + 1)?;
        }
    }

    fn skip(&mut self, length: usize) -> Result<(), Error> {
        if length > self.end - self.at {
            return Err(Error::Truncated { at: self.at });
        }
        self.at += length;
        Ok(())
    }

    fn take_double(&mut self) -> Result<f64, Error> {
        let at = self.at;
        self.skip(8)?;
        self.datagram[at..self.at]
            .first_chunk()
            .map(|bytes| f64::from_le_bytes(*bytes))
            .ok_or(Error::Truncated { at })
    }

    fn take_varint(&mut self) -> Result<u64, Error> {
        let at = self.at;
        let mut value = 0u64;
        for place in 0..10 {
            if self.at == self.end {
                return Err(Error::Truncated { at });
            }
            let byte = self.datagram[self.at];
            self.at += 1;
            // The tenth byte has room for the 64th bit alone.
            if place == 9 && byte > 1 {
                break;
            }
            value |= u64::from(byte & 0x7f) << (7 * place);
            if byte < 0x80 {
                return Ok(value);
            }
        }
        Err(Error::Malformed { at })
    }
}
