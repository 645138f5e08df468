/**
 * Recordings read as messages of U2SA, and played at their own pace. The file format is in {@code
 * recorder.mcap}.
 */
package org.u2sa.recorder.playback;
