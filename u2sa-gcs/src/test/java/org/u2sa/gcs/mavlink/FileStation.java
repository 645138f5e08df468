package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.FileTransferProtocol;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** A station that asks for files by MAVLink FTP. */
final class FileStation {
  static final int OPEN = 4;
  static final int READ = 5;
  static final int CHECKSUM = 14;
  static final int BURST = 15;

  /** An answer; of a NAK, {@code data} is the code. */
  record Answer(
      int sequence, int session, boolean ack, int request, long offset, boolean last, byte[] data) {
    int code() {
      assertThat(ack).isFalse();
      assertThat(data).hasSize(1);
      return data[0];
    }

    int number() {
      return ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN).getInt();
    }
  }

  private final BridgeKit kit;
  private int sequence = 0xFFF0; // wraps around soon

  FileStation(BridgeKit kit) {
    this.kit = kit;
  }

  List<Answer> ask(int opcode, int session, long offset, int size, byte[] data) {
    sequence = sequence + 1 & 0xFFFF;
    return repeat(opcode, session, offset, size, data);
  }

  /** The same with the number of the request before. */
  List<Answer> repeat(int opcode, int session, long offset, int size, byte[] data) {
    ByteBuffer payload = ByteBuffer.allocate(251).order(ByteOrder.LITTLE_ENDIAN);
    payload.putShort((short) sequence).put((byte) session).put((byte) opcode).put((byte) size);
    payload.put(new byte[3]).putInt((int) offset).put(data);
    kit.send(
        FileTransferProtocol.builder()
            .targetSystem(1)
            .targetComponent(1)
            .payload(payload.array())
            .build());
    return answers();
  }

  /** A request with the sequence number of some requests ago. */
  List<Answer> late(int requests, int opcode, int session) {
    int newest = sequence;
    sequence = newest - requests & 0xFFFF;
    List<Answer> answers = repeat(opcode, session, 0, 10, new byte[0]);
    sequence = newest;
    return answers;
  }

  List<Answer> answers() {
    List<Answer> answers = new ArrayList<>();
    for (FileTransferProtocol each : kit.received(FileTransferProtocol.class)) {
      ByteBuffer in =
          ByteBuffer.wrap(Arrays.copyOf(each.payload(), 251)).order(ByteOrder.LITTLE_ENDIAN);
      assertThat(each.targetSystem()).isEqualTo(BridgeKit.STATION);
      byte[] data = Arrays.copyOfRange(in.array(), 12, 12 + (in.get(4) & 0xFF));
      answers.add(
          new Answer(
              in.getShort(0) & 0xFFFF,
              in.get(2),
              (in.get(3) & 0xFF) == 128,
              in.get(5) & 0xFF,
              in.getInt(8) & 0xFFFF_FFFFL,
              in.get(6) == 1,
              data));
    }
    return answers;
  }

  Answer one(int opcode, int session, String path) {
    byte[] data = path.getBytes(StandardCharsets.ISO_8859_1);
    List<Answer> answers = ask(opcode, session, 0, data.length, data);
    assertThat(answers).hasSize(1);
    Answer answer = answers.get(0);
    assertThat(answer.sequence()).isEqualTo(sequence + 1 & 0xFFFF);
    assertThat(answer.request()).isEqualTo(opcode);
    return answer;
  }

  /** Downloads by bursts and terminates the session. */
  byte[] download(String path) {
    Answer opened = one(OPEN, 0, path);
    assertThat(opened.ack()).isTrue();
    int size = opened.number();
    ByteArrayOutputStream content = new ByteArrayOutputStream();
    while (content.size() < size) {
      List<Answer> burst =
          new ArrayList<>(ask(BURST, opened.session(), content.size(), 239, new byte[0]));
      int first = sequence;
      while (!burst.get(burst.size() - 1).last()) {
        kit.step();
        burst.addAll(answers());
      }
      for (int i = 0; i < burst.size(); i++) {
        assertThat(burst.get(i).sequence()).isEqualTo(first + 1 + i & 0xFFFF);
        assertThat(burst.get(i).offset()).isEqualTo(content.size());
        content.writeBytes(burst.get(i).data());
      }
    }
    assertThat(ask(BURST, opened.session(), size, 239, new byte[0]).get(0).code()).isEqualTo(6);
    assertThat(ask(1, opened.session(), 0, 0, new byte[0]).get(0).ack()).isTrue();
    return content.toByteArray();
  }
}
