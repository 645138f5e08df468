package org.u2sa.recorder.mcap;

/** What a writer may leave out of a file, all of it optional by the specification. */
public enum McapFeature {
  /** Messages are gathered, and compressed, in chunks. */
  CHUNKS,
  /** Each definition stands in two chunks, so that no damaged chunk takes the only one with it. */
  DEFINITIONS_TWICE,
  /** After each chunk stands where each message is in it. */
  MESSAGE_INDEX,
  /** The summary counts messages, channels and the like. */
  STATISTICS,
  /** The summary repeats all schemas. */
  REPEATED_SCHEMAS,
  /** The summary repeats all channels. */
  REPEATED_CHANNELS,
  /** The summary says where each attachment is. */
  ATTACHMENT_INDEX,
  /** The summary says where each metadata record is. */
  METADATA_INDEX,
  /** The summary says where each chunk is, and of which times. */
  CHUNK_INDEX,
  /** After the summary stands where each kind of record is in it. */
  SUMMARY_OFFSETS,
  /** Bytes follow the last field of records, as a later version of the format may have it. */
  LATER_FIELDS
}
