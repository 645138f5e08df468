package org.u2sa.gcs.mavlink.file;

import io.dronefleet.mavlink.common.FileTransferProtocol;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.gcs.mavlink.file.FilePacket.Refusal;
import org.u2sa.gcs.mavlink.station.GroundStation;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;

/**
 * MAVLink FTP for one station (mavlink.io/en/services/ftp), read-only. Each sender has its own
 * sessions, numbered from 0, because MAVSDK 4.1 uses 0 regardless of the number in the answer.
 */
public final class FileTransfer {
  private static final int MAX_SESSIONS = 8;
  private static final int PACKETS_PER_STEP = 64;
  private static final long IDLE_MICROS =
      30_000_000; // after this idle time, the session may be reused

  private record SessionKey(Sender owner, int number) {}

  /**
   * A request that stations repeat if its answer is lost; the repetition must not open another
   * session.
   */
  private record Opening(byte[] request, Sender from, FilePacket answer) {}

  private final OfferedFiles files;
  private final GroundStation station;
  private final ChecksumJob checksum = new ChecksumJob();
  private final Map<SessionKey, FileSession> sessions = new LinkedHashMap<>();
  private Optional<Opening> opening = Optional.empty(); // the newest request, if it opened a file
  private long nowMicros;

  /** Serves a station. */
  public FileTransfer(OfferedFiles files, GroundStation station) {
    this.files = files;
    this.station = station;
  }

  /** Answers a request. */
  public void handle(FileTransferProtocol message, Sender from) {
    FilePacket request = FilePacket.parse(message.payload());
    Optional<Opening> before = opening;
    opening = Optional.empty();
    try {
      if (before.isPresent()
          && before.get().from().equals(from)
          && Arrays.equals(before.get().request(), request.payload())) {
        opening = before;
        send(before.get().answer(), from);
        return;
      }
      answer(request, from).ifPresent(each -> send(each, from));
    } catch (IOException e) {
      send(request.nak(Refusal.FAIL), from);
    }
  }

  private Optional<FilePacket> answer(FilePacket request, Sender from) throws IOException {
    return switch (request.opcode()) {
      case 0 -> Optional.of(request.ack(new byte[0]));
      case FilePacket.RESET_SESSIONS -> {
        sessions.keySet().removeIf(each -> each.owner().equals(from));
        yield Optional.of(request.ack(new byte[0]));
      }
      case FilePacket.LIST_DIRECTORY -> Optional.of(list(request));
      case FilePacket.OPEN_FILE -> Optional.of(open(request, from));
      case FilePacket.TERMINATE_SESSION, FilePacket.READ_FILE, FilePacket.BURST_READ ->
          ofSession(request, from);
      case FilePacket.CHECKSUM -> {
        Optional<ReadableFile> file = named(request);
        file.ifPresent(each -> checksum.begin(request, from, each));
        yield file.isPresent() ? Optional.empty() : Optional.of(request.nak(notFound(request)));
      }
      default ->
          Optional.of(
              request.nak(isWrite(request) ? Refusal.FILE_PROTECTED : Refusal.UNKNOWN_COMMAND));
    };
  }

  private static boolean isWrite(FilePacket request) {
    return request.opcode() >= FilePacket.CREATE_FILE && request.opcode() <= FilePacket.RENAME;
  }

  private Optional<FilePacket> ofSession(FilePacket request, Sender from) throws IOException {
    SessionKey key = new SessionKey(from, request.session());
    FileSession session = sessions.get(key);
    if (session == null) {
      return Optional.of(request.nak(Refusal.INVALID_SESSION));
    }
    if (session.isAfter(request, nowMicros)) {
      return Optional.empty(); // its first answer has arrived
    }
    session.usedMicros = nowMicros;
    return switch (request.opcode()) {
      case FilePacket.READ_FILE -> Optional.of(session.read(request));
      case FilePacket.BURST_READ -> session.begin(request);
      default -> {
        sessions.remove(key);
        yield Optional.of(request.ack(new byte[0]));
      }
    };
  }

  private Optional<ReadableFile> named(FilePacket request) throws IOException {
    return request.size() > FilePacket.MAX_DATA ? Optional.empty() : files.open(request.path());
  }

  private static Refusal notFound(FilePacket request) {
    return request.size() > FilePacket.MAX_DATA
        ? Refusal.INVALID_DATA_SIZE
        : Refusal.FILE_NOT_FOUND;
  }

  private FilePacket list(FilePacket request) throws IOException {
    Optional<List<String>> entries =
        request.size() > FilePacket.MAX_DATA ? Optional.empty() : files.list(request.path());
    if (entries.isEmpty()) {
      return request.nak(notFound(request));
    }
    if (request.offset() >= entries.get().size()) {
      return request.nak(Refusal.END_OF_FILE);
    }
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    for (int i = (int) request.offset(); i < entries.get().size(); i++) {
      byte[] entry = (entries.get().get(i) + '\0').getBytes(StandardCharsets.US_ASCII);
      if (packed.size() + entry.length > FilePacket.MAX_DATA) {
        break;
      }
      packed.writeBytes(entry);
    }
    return request.ack(packed.toByteArray());
  }

  private FilePacket open(FilePacket request, Sender from) throws IOException {
    Optional<ReadableFile> file = named(request);
    if (file.isEmpty()) {
      return request.nak(notFound(request));
    }
    sessions.values().removeIf(each -> nowMicros - each.usedMicros > IDLE_MICROS);
    if (sessions.size() >= MAX_SESSIONS) {
      return request.nak(Refusal.NO_SESSIONS_AVAILABLE);
    }
    int number = 0;
    while (sessions.containsKey(new SessionKey(from, number))) {
      number++;
    }
    sessions.put(
        new SessionKey(from, number), new FileSession(request, from, file.get(), nowMicros));
    byte[] size =
        ByteBuffer.allocate(Integer.BYTES)
            .order(ByteOrder.LITTLE_ENDIAN)
            .putInt((int) file.get().size())
            .array();
    FilePacket answer = request.ack(number, 0, size);
    opening = Optional.of(new Opening(request.payload(), from, answer));
    return answer;
  }

  /** Sends the next part of bursts and checksums. */
  public void step(long micros) {
    nowMicros = micros;
    checksum.step().ifPresent(each -> send(each, checksum.from()));
    for (int sent = 0; sent < PACKETS_PER_STEP && station.hasRoom(); sent++) {
      boolean isIdle = true;
      for (FileSession each : sessions.values()) {
        isIdle &= !burst(each);
      }
      if (isIdle) {
        return;
      }
    }
  }

  private boolean burst(FileSession session) {
    try {
      Optional<FilePacket> packet = session.next();
      packet.ifPresent(each -> send(each, session.owner));
      if (packet.isPresent()) {
        session.usedMicros = nowMicros;
      }
      return packet.isPresent();
    } catch (IOException e) {
      send(session.fail(), session.owner);
      return true;
    }
  }

  private void send(FilePacket packet, Sender to) {
    station.send(
        FileTransferProtocol.builder()
            .targetNetwork(0)
            .targetSystem(to.system())
            .targetComponent(to.component())
            .payload(packet.payload())
            .build());
  }
}
