/**
 * The command that runs any system file, in one process or one process a service, and the list of
 * all commands of this module. How systems are started belongs to the core module.
 */
package org.u2sa.gcs.run;
