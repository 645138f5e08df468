/**
 * Building blocks of commands: provider, exit codes, settings. The command tree is in {@code cli}.
 */
package org.u2sa.cli.command;
