//! What a lander is made of, as plain data: parts, tables, attitudes, rules to choose from.

pub mod attitude;
pub mod crush_load;
pub mod invalid;
pub mod parts;
pub mod profile;
pub mod rules;
