//! What is loaded: the tasks of the controller and their modules. Running them is in [`crate::rapid`].

use crate::hal::Entries;
use crate::{Client, RwsError};

/// One RAPID task.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Task {
    /// For example `T_ROB1`.
    pub name: String,
    /// Whether it is switched on.
    pub active: bool,
    /// Whether it moves the arm.
    pub moves_arm: bool,
}

/// One module of a task.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Module {
    /// Its name.
    pub name: String,
    /// `ProgMod` or `SysMod`.
    pub kind: String,
}

impl Client {
    /// Reads the tasks of the controller.
    ///
    /// # Errors
    /// As for every call.
    pub async fn tasks(&self) -> Result<Vec<Task>, RwsError> {
        let path = "/rw/rapid/tasks";
        let text = self.get(path).await?;
        let tasks = Entries::parse(path, &text)?;
        tasks
            .of_type("rap-task-li")
            .map(|task| {
                Ok(Task {
                    name: task.text("name")?,
                    active: task.optional_text("active").eq_ignore_ascii_case("on"),
                    moves_arm: task
                        .optional_text("motiontask")
                        .eq_ignore_ascii_case("true"),
                })
            })
            .collect()
    }

    /// Reads which modules are loaded in a task.
    ///
    /// # Errors
    /// [`RwsError::Missing`] when there is no such task.
    pub async fn modules(&self, task: &str) -> Result<Vec<Module>, RwsError> {
        let path = format!("/rw/rapid/tasks/{task}/modules");
        let text = self.get(&path).await?;
        let modules = Entries::parse(&path, &text)?;
        modules
            .of_type("rap-module-info-li")
            .map(|module| {
                Ok(Module {
                    name: module.text("name")?,
                    kind: module.optional_text("type"),
                })
            })
            .collect()
    }
}
