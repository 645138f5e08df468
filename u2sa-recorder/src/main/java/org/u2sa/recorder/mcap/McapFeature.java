package org.u2sa.recorder.mcap;

/** Optional contents of a file according to the specification. */
public enum McapFeature {
  /** Groups and compresses messages in chunks. */
  CHUNKS,
  /** Repeats each definition in two chunks, so that one damaged chunk does not lose it. */
  DEFINITIONS_TWICE,
  /** Message indexes after each chunk. */
  MESSAGE_INDEX,
  /** Statistics in the summary. */
  STATISTICS,
  /** Schemas repeated in the summary. */
  REPEATED_SCHEMAS,
  /** Channels repeated in the summary. */
  REPEATED_CHANNELS,
  /** Attachment indexes in the summary. */
  ATTACHMENT_INDEX,
  /** Metadata indexes in the summary. */
  METADATA_INDEX,
  /** Chunk indexes in the summary: position and time range. */
  CHUNK_INDEX,
  /** Summary offsets: position of each kind of record in the summary. */
  SUMMARY_OFFSETS,
  /** Extra bytes after the last field of records, as in possible later versions of the format. */
  LATER_FIELDS
}
