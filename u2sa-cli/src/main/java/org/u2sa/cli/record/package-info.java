/**
 * Commands about recordings: making them, making broken ones whole, playing them. The recorder and
 * its files are u2sa-recorder's.
 */
package org.u2sa.cli.record;
