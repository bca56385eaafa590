//! Robot Web Services on their socket: what a client gets that does it right, and one that does not.

#[cfg(test)]
mod access;
#[cfg(test)]
mod acting;
#[cfg(test)]
mod cell;
#[cfg(test)]
mod subscriptions;
