-- Phones that know the pairing code, and who did what.

CREATE TABLE pairing_session (
    token_sha256  BLOB    NOT NULL PRIMARY KEY CHECK (length(token_sha256) = 32),
    created_at_ms INTEGER NOT NULL,
    expires_at_ms INTEGER NOT NULL,
    address       TEXT    NOT NULL
) STRICT;

CREATE TABLE audit_event (
    id      INTEGER NOT NULL PRIMARY KEY,
    at_ms   INTEGER NOT NULL,
    actor   TEXT    NOT NULL,
    action  TEXT    NOT NULL,
    subject TEXT    NOT NULL
) STRICT;
