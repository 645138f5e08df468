/**
 * The command that lists U2SA's libraries, their age and published advisories, from two dated files
 * in the jar. Works offline.
 */
package org.u2sa.cli.dependencies;
