/**
 * MCAP files as specified by mcap.dev: writing, reading, and recovery of damaged files. Independent
 * of the messages' content.
 */
package org.u2sa.recorder.mcap;
