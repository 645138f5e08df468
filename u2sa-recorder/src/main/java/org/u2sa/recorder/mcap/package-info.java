/**
 * MCAP files, as mcap.dev specifies them: writing, reading, and making whole again what broke off.
 * What the messages in them say is no concern of this package.
 */
package org.u2sa.recorder.mcap;
