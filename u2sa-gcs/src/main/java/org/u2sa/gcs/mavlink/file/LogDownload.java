package org.u2sa.gcs.mavlink.file;

import io.dronefleet.mavlink.common.LogData;
import io.dronefleet.mavlink.common.LogEntry;
import io.dronefleet.mavlink.common.LogErase;
import io.dronefleet.mavlink.common.LogRequestData;
import io.dronefleet.mavlink.common.LogRequestEnd;
import io.dronefleet.mavlink.common.LogRequestList;
import io.dronefleet.mavlink.common.MavSeverity;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import org.u2sa.gcs.mavlink.station.GroundStation;

/**
 * Offers recordings as logs to one station (LOG_REQUEST_LIST and related messages). Numbers begin
 * at 1 with the oldest name; sizes are those of the last list.
 */
public final class LogDownload {
  private static final int PER_STEP = 64;
  private static final int DATA = 90;

  private final OfferedFiles files;
  private final GroundStation station;
  private List<RecordingFolder.Entry> logs = List.of();
  private int nextEntry = 1;
  private int lastEntry;
  private int sending; // number of the log being sent; 0: none
  private ReadableFile file;
  private long at;
  private long end;

  /** Serves a station. */
  public LogDownload(OfferedFiles files, GroundStation station) {
    this.files = files;
    this.station = station;
  }

  /** Handles a message if it concerns logs. */
  public void handle(Object message) {
    if (message instanceof LogRequestList request) {
      list(request);
    } else if (message instanceof LogRequestData request) {
      begin(request);
    } else if (message instanceof LogRequestEnd) {
      sending = 0;
    } else if (message instanceof LogErase) {
      station.text(
          MavSeverity.MAV_SEVERITY_WARNING, "logs not erased: stations may only read recordings");
    }
  }

  private void list(LogRequestList request) {
    renew();
    nextEntry = Math.max(1, request.start());
    lastEntry = Math.min(logs.size(), request.end());
    if (logs.isEmpty()) {
      station.send(LogEntry.builder().id(0).numLogs(0).lastLogNum(0).timeUtc(0).size(0).build());
    }
  }

  private void renew() {
    try {
      logs = files.recordings();
    } catch (IOException e) {
      logs = List.of();
      station.text(MavSeverity.MAV_SEVERITY_WARNING, "recordings cannot be listed: " + e);
    }
  }

  private void begin(LogRequestData request) {
    if (logs.isEmpty()) {
      renew(); // a station may know the list from an earlier connection
    }
    if (request.id() < 1 || request.id() > logs.size()) {
      return; // there is no answer for unknown logs
    }
    if (sending != request.id()) {
      file = logs.get(request.id() - 1).open();
    }
    sending = request.id();
    at = request.ofs();
    end = Math.min(file.size(), at + request.count());
    if (at >= end) {
      send(new byte[0]); // count 0: the end of the log
      sending = 0;
    }
  }

  /** Sends the next part of the list and of the log. */
  public void step() {
    int sent = 0;
    for (; sent < PER_STEP && nextEntry <= lastEntry && station.hasRoom(); sent++) {
      RecordingFolder.Entry log = logs.get(nextEntry - 1);
      station.send(
          LogEntry.builder()
              .id(nextEntry++)
              .numLogs(logs.size())
              .lastLogNum(logs.size())
              .timeUtc(log.seconds())
              .size(log.size())
              .build());
    }
    try {
      for (; sent < PER_STEP && sending != 0 && station.hasRoom(); sent++) {
        byte[] data = file.read(at, (int) Math.min(DATA, end - at));
        send(data);
        at += data.length;
        sending = at < end ? sending : 0;
      }
    } catch (IOException e) {
      sending = 0;
      station.text(MavSeverity.MAV_SEVERITY_WARNING, "the recording cannot be read: " + e);
    }
  }

  private void send(byte[] data) {
    station.send(
        LogData.builder()
            .id(sending)
            .ofs(at)
            .count(data.length)
            .data(Arrays.copyOf(data, DATA))
            .build());
  }
}
