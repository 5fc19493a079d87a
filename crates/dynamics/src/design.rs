//! Plain data of a lander: parts, tables, attitudes, rules to choose from; the catalogue of their numbers.

pub mod attitude;
pub mod crush_load;
pub mod invalid;
pub mod parts;
pub mod profile;
pub mod quantities;
pub mod quantity;
pub mod rules;
pub mod soil;
pub mod three_struts;
