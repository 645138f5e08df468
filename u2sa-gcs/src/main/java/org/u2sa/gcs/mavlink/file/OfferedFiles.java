package org.u2sa.gcs.mavlink.file;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The files of a vehicle, all of them virtual: component metadata, and recordings if there is a
 * folder for them. No path of the host is accessible.
 */
public final class OfferedFiles {
  private static final String LOGS = "logs";

  private final ComponentMetadataFiles metadata;
  private final Optional<RecordingFolder> recordings;

  /**
   * @param recordings folder whose recordings stations may download; empty: none
   */
  public OfferedFiles(ComponentMetadataFiles metadata, Optional<RecordingFolder> recordings) {
    this.metadata = metadata;
    this.recordings = recordings;
  }

  /** Recordings, oldest name first. */
  List<RecordingFolder.Entry> recordings() throws IOException {
    return recordings.isPresent() ? recordings.get().entries() : List.of();
  }

  /** Opens a file; empty if the path does not exist. */
  Optional<ReadableFile> open(String path) throws IOException {
    String relative = relative(path);
    if (relative.startsWith(LOGS + "/") && recordings.isPresent()) {
      return recordings
          .get()
          .entry(relative.substring(LOGS.length() + 1))
          .map(RecordingFolder.Entry::open);
    }
    return metadata.content(relative).map(ReadableFile::of);
  }

  /**
   * Entries of a folder as MAVLink FTP lists them: {@code F<name>\t<size>} or {@code D<name>}.
   * Empty if the folder does not exist.
   */
  Optional<List<String>> list(String path) throws IOException {
    String relative = relative(path);
    List<String> entries = new ArrayList<>();
    if (relative.isEmpty()) {
      for (String each : ComponentMetadataFiles.NAMES) {
        entries.add("F" + each + "\t" + metadata.content(each).orElseThrow().length);
      }
      recordings.ifPresent(each -> entries.add("D" + LOGS));
    } else if (relative.equals(LOGS) && recordings.isPresent()) {
      for (RecordingFolder.Entry each : recordings.get().entries()) {
        entries.add("F" + each.name() + "\t" + each.size());
      }
    } else {
      return Optional.empty();
    }
    return Optional.of(entries);
  }

  private static String relative(String path) {
    return path.replaceAll("^/+|/+$", "");
  }
}
