//! The checks of how a robot's controller is reached: address, account and certificate.

use std::path::Path;

use robot::RobotKind;
use toml::Spanned;

use super::{Checked, OneRobot};
use crate::cell::address::{fingerprint, wrong_url};
use crate::cell::{Account, Controller, Secret};

impl OneRobot<'_> {
    pub(super) fn controller(&self, kind: RobotKind) -> Checked<Option<Controller>> {
        let table = &self.table;
        if let Some(password) = &table.rws_password {
            let what = "a password must not be in this file";
            let advice = "write it into a file of its own that only the server may read, name that in rws_password_file, and change the password";
            return Err(self.wrong(password, "rws_password", what, advice));
        }
        if kind == RobotKind::Virtual {
            let given = [
                ("rws_url", &table.rws_url),
                ("rws_user", &table.rws_user),
                ("rws_password_file", &table.rws_password_file),
                ("rws_password_env", &table.rws_password_env),
                ("rws_certificate_sha256", &table.rws_certificate_sha256),
            ];
            for (name, field) in given {
                if let Some(field) = field {
                    let what = "a virtual robot brings its own controller";
                    return Err(self.wrong(
                        field,
                        name,
                        what,
                        "leave it out, or write kind = \"gofa\"",
                    ));
                }
            }
            return Ok(None);
        }
        let form =
            "write the controller's address, for example rws_url = \"https://192.168.125.1\"";
        let url = self.needed(&table.rws_url, "rws_url", form)?;
        if let Some(what) = wrong_url(url.get_ref()) {
            return Err(self.wrong(url, "rws_url", what, form));
        }
        Ok(Some(Controller {
            rws_url: url.get_ref().clone(),
            account: self.account()?,
            certificate_sha256: self.certificate(url)?,
        }))
    }

    fn account(&self) -> Checked<Option<Account>> {
        let table = &self.table;
        let password = match (&table.rws_password_file, &table.rws_password_env) {
            (Some(_), Some(both)) => {
                let what = "the password is named twice";
                let advice = "keep rws_password_file or rws_password_env, not both";
                return Err(self.wrong(both, "rws_password_env", what, advice));
            }
            (Some(file), None) => Some((file, "rws_password_file", self.password_in(file)?)),
            (None, Some(name)) => {
                let what = format!("there is no environment variable {}", name.get_ref());
                let advice = "set it before the server starts";
                let value = (self.source.environment)(name.get_ref())
                    .ok_or_else(|| self.wrong(name, "rws_password_env", &what, advice))?;
                Some((name, "rws_password_env", value))
            }
            (None, None) => None,
        };
        match (&table.rws_user, password) {
            (None, None) => Ok(None),
            (Some(user), None) => {
                let advice = "name its password's file in rws_password_file";
                Err(self.wrong(user, "rws_user", "this account has no password", advice))
            }
            (None, Some((field, name, _))) => {
                let advice = "name the controller's account in rws_user";
                Err(self.wrong(field, name, "this password has no account", advice))
            }
            (Some(_), Some((field, name, password))) if password.is_empty() => Err(self.wrong(
                field,
                name,
                "the password is empty",
                "put the password there",
            )),
            (Some(user), Some((_, _, password))) => Ok(Some(Account {
                user: user.get_ref().clone(),
                password: Secret(password),
            })),
        }
    }

    /// The password in a file beside the configuration; editors end it with a line end.
    fn password_in(&self, file: &Spanned<String>) -> Checked<String> {
        let folder = self.source.file.parent().unwrap_or(Path::new(""));
        let path = folder.join(file.get_ref());
        let text = std::fs::read_to_string(&path).map_err(|error| {
            let what = format!("{} can't be read: {error}", path.display());
            let advice = "make that file, with nothing but the password in it";
            self.wrong(file, "rws_password_file", &what, advice)
        })?;
        Ok(text.trim_end_matches(['\n', '\r']).to_owned())
    }

    fn certificate(&self, url: &Spanned<String>) -> Checked<Option<String>> {
        const NAME: &str = "rws_certificate_sha256";
        let Some(field) = &self.table.rws_certificate_sha256 else {
            return Ok(None);
        };
        let Some(digits) = fingerprint(field.get_ref()) else {
            let what = "this is not a SHA-256 fingerprint";
            let advice = "write its 64 hexadecimal digits; colons between them are allowed";
            return Err(self.wrong(field, NAME, what, advice));
        };
        if url.get_ref().starts_with("http://") {
            let what = "there is no certificate without https";
            let advice = "write https:// in rws_url, or leave the fingerprint out";
            return Err(self.wrong(field, NAME, what, advice));
        }
        Ok(Some(digits))
    }
}
