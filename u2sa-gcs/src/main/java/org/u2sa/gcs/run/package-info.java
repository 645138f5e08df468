/**
 * The command that runs any system file, in one process or one process a service. How systems are
 * started belongs to the core module.
 */
package org.u2sa.gcs.run;
