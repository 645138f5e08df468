/**
 * Export of recordings to other formats: tables, map tracks, viewers. Reading recordings is in
 * {@code org.u2sa.gcs.record}.
 */
package org.u2sa.gcs.export;
