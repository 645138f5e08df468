/**
 * Recordings read as U2SA messages, and played at their own pace. The file format is in {@code
 * recorder.mcap}.
 */
package org.u2sa.recorder.playback;
