/**
 * The command that runs any system file, in one process or one process per service, and the list of
 * all commands of this module. Starting systems belongs to the core module.
 */
package org.u2sa.cli.run;
