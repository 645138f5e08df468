/**
 * Commands that show the messages of a running system and publish a message by hand. All except
 * {@code publish} are read-only. Recordings belong to {@code record}.
 */
package org.u2sa.cli.look;
