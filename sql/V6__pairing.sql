-- Of the certificate that pairing recorded: SHA-256, hex; null: the link to the robot is not encrypted.
alter table robots add column fingerprint char(64);
