package org.u2sa.recorder;

import java.util.OptionalInt;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.recorder.mcap.ChunkCompression;

/** The variables of a {@link Recorder}. */
record RecorderVariables(
    @Variable(ifAbsentText = "recording.mcap")
        @Description(
            "File to record into, relative to the folder of the log files. If it exists, a number is appended to the name.")
        String file,
    @Variable(ifAbsentText = "BOTH") @Description("Format in which messages are recorded.")
        Form form,
    @Variable(ifAbsentText = "LZ4") @Description("Compression of the file.")
        ChunkCompression compression,
    @Variable(min = 0, max = 1_000_000, ifAbsent = 0)
        @Description("Size at which the next file is started, in megabytes (10^6 bytes); 0: never.")
        double splitMegabytes,
    @Variable(unit = "s", min = 0, max = 1_000_000, ifAbsent = 0)
        @Description("Time after which the next file is started; 0: never.")
        double splitTime,
    @Variable(min = 0, max = 100_000, ifAbsent = 0)
        @Description("Number of files to keep: beyond it, the oldest is deleted; 0: all are kept.")
        int keep,
    @Variable(ifAbsentText = "true")
        @Description(
            "Whether to record which service handled which message when, so that services can be re-executed.")
        boolean executions,
    @Variable(min = 16, max = 1_000_000, ifAbsent = 8192)
        @Description("Capacity of the write queue in messages; more are dropped and counted.")
        int waitingAtMost) {
  enum Form {
    /** Native messages (CBOR). */
    U2SA,
    /** Foxglove types only; messages without a counterpart are not recorded. */
    FOXGLOVE,
    /** Native messages, plus Foxglove types where a counterpart exists. */
    BOTH
  }

  private static final double BYTES_PER_MEGABYTE = 1e6;

  /** File size limit [B]; {@code Long.MAX_VALUE} if unlimited. */
  long splitBytes() {
    return splitMegabytes == 0 ? Long.MAX_VALUE : Math.round(splitMegabytes * BYTES_PER_MEGABYTE);
  }

  /** File duration limit [ns]; {@code Long.MAX_VALUE} if unlimited. */
  long splitNanos() {
    return splitTime == 0 ? Long.MAX_VALUE : Math.round(splitTime * 1e9);
  }

  boolean splits() {
    return splitMegabytes > 0 || splitTime > 0;
  }

  OptionalInt keptAtMost() {
    return keep == 0 ? OptionalInt.empty() : OptionalInt.of(keep);
  }

  boolean recordsMessages() {
    return form != Form.FOXGLOVE;
  }

  boolean keepsExecutions() {
    return executions && recordsMessages();
  }

  boolean recordsFoxglove() {
    return form != Form.U2SA;
  }
}
