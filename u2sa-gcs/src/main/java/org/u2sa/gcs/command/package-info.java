/**
 * What a command needs of the command line: its provider, exit codes, failures, files it writes.
 * The tree of commands is in {@code gcs}.
 */
package org.u2sa.gcs.command;
