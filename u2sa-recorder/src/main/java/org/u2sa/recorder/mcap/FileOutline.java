package org.u2sa.recorder.mcap;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.util.OptionalLong;
import java.util.function.Consumer;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapStatistics;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordFields;

/** Outline of a possibly damaged file, from the records outside chunks. */
final class FileOutline {
  private final FileWindow file;
  private final OptionalLong messages;
  private final long dataEnd;
  private final long dataCrc;

  private FileOutline(FileWindow file, OptionalLong messages, long dataEnd, long dataCrc) {
    this.file = file;
    this.messages = messages;
    this.dataEnd = dataEnd;
    this.dataCrc = dataCrc;
  }

  /** Scans a file's records without reading its chunks; collects definitions outside them. */
  static FileOutline of(FileChannel channel, Definitions definitions, Consumer<String> trouble)
      throws IOException {
    Summary summary = findSummary(channel, trouble);
    RecordSearch search = new RecordSearch(channel, known -> {});
    OptionalLong messages = OptionalLong.empty();
    for (RecordSearch.Found f = search.next(); f != null; f = search.next()) {
      Definitions.Source source = Definitions.Source.DATA;
      if (f.offset() >= summary.begin) {
        source =
            summary.isIntact
                ? Definitions.Source.INTACT_SUMMARY
                : Definitions.Source.DAMAGED_SUMMARY;
      }
      boolean isStatistics = f.opcode() == Opcode.STATISTICS && summary.isIntact;
      if (isStatistics || f.opcode() == Opcode.SCHEMA || f.opcode() == Opcode.CHANNEL) {
        try {
          RecordFields in =
              new RecordFields(new RecordStream(channel, f.contentAt()).bytes(f.length()));
          if (isStatistics) {
            messages = OptionalLong.of(McapStatistics.read(in).messages());
          } else {
            definitions.take(source, f.opcode(), in);
          }
        } catch (McapException e) {
          trouble.accept(e.getMessage());
        }
      }
    }
    return new FileOutline(search.file(), messages, summary.dataEnd, summary.dataCrc);
  }

  /**
   * Start of the summary, whether its checksum is correct, end and checksum of the data section.
   */
  private record Summary(long begin, boolean isIntact, long dataEnd, long dataCrc) {}

  private static Summary findSummary(FileChannel channel, Consumer<String> trouble)
      throws IOException {
    RecordSearch search = new RecordSearch(channel, trouble);
    RecordSearch.Found dataEnd = null;
    RecordSearch.Found footer = null;
    for (RecordSearch.Found f = search.next(); f != null; f = search.next()) {
      dataEnd = f.opcode() == Opcode.DATA_END ? f : dataEnd;
      footer = f.opcode() == Opcode.FOOTER ? f : footer;
    }
    if (dataEnd == null || footer == null) {
      trouble.accept("the file has no end of its data, or no footer");
    }
    FileWindow file = search.file();
    long dataCrc = dataEnd == null ? 0 : file.uint32(dataEnd.contentAt());
    long end = dataEnd == null ? 0 : dataEnd.offset();
    long begin = dataEnd == null ? Long.MAX_VALUE : dataEnd.end();
    boolean isIntact = false;
    if (footer != null && file.uint64(footer.contentAt()) != 0) {
      long said = file.uint64(footer.contentAt());
      long crc = file.uint32(footer.end() - Integer.BYTES);
      boolean isPlace = said > 0 && said < footer.offset();
      isIntact = isPlace && (crc == 0 || crc == file.crc(said, footer.end() - Integer.BYTES));
      begin = isIntact ? said : begin;
      if (!isIntact) {
        trouble.accept("the summary is damaged: its checksum is wrong");
      }
    }
    return new Summary(begin, isIntact, end, dataCrc);
  }

  /** Number of messages, if an intact summary states it. */
  OptionalLong messages() {
    return messages;
  }

  /** Verifies the checksum of the data section, which also covers the bytes between chunks. */
  void checkData(Consumer<String> trouble) throws IOException {
    if (dataCrc != 0 && dataCrc != file.crc(0, dataEnd)) {
      trouble.accept("a byte between the chunks is wrong: the checksum of all data does not match");
    }
  }
}
