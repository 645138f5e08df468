/**
 * Recordings and tracks in other formats: tables, map tracks, viewers. Reading recordings is in
 * {@code org.u2sa.recorder.playback}.
 */
package org.u2sa.report.export;
