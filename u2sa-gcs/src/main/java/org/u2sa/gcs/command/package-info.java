/**
 * Building blocks of commands: provider, exit codes, failures, output files. The command tree is in
 * {@code gcs}.
 */
package org.u2sa.gcs.command;
