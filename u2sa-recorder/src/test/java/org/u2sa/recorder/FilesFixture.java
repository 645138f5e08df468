package org.u2sa.recorder;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.record.McapMessage;

/** Files of a recording on a disk of limited size. */
abstract class FilesFixture {
  static final long SECOND = 1_000_000_000L;
  static final long PLENTY = 1L << 30;

  @TempDir Path top;
  final List<String> troubles = new ArrayList<>();
  final RecordingFacts facts = new RecordingFacts();
  final SmallDisk disk = new SmallDisk(PLENTY);
  long sequence;

  static RecorderVariables settings(Map<String, ?> values) {
    return XmlConfiguration.inMemory("Recorder", new HashMap<>(values))
        .settings(RecorderVariables.class)
        .get();
  }

  RecordingFiles files(Path file, Map<String, Object> values, RecordingFiles.Disk on) {
    Map<String, Object> all = new HashMap<>(values);
    all.put("COMPRESSION", "NONE");
    return new RecordingFiles(file, settings(all), "test", facts, troubles::add, on);
  }

  static List<Long> sequences(Path file) throws IOException {
    List<Long> all = new ArrayList<>();
    try (McapReader reader = McapReader.open(file)) {
      McapCursor cursor = reader.messages(0, channel -> true);
      for (Optional<McapMessage> m = cursor.next(); m.isPresent(); m = cursor.next()) {
        all.add(m.get().sequence());
      }
    }
    return all;
  }
}
