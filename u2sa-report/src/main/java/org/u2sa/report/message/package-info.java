/**
 * Text forms of messages: JSON by their types' schema, field paths, conditions on fields. Commands
 * that use them are elsewhere.
 */
package org.u2sa.report.message;
