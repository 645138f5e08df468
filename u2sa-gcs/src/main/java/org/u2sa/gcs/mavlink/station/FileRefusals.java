package org.u2sa.gcs.mavlink.station;

import io.dronefleet.mavlink.common.FileTransferProtocol;
import java.util.Arrays;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;

/**
 * Answers file requests (mavlink.io/en/services/ftp): the vehicle has no files. Stations that ask
 * for one by FTP go on at once instead of waiting for a timeout.
 */
public final class FileRefusals {
  private static final int PAYLOAD = 251;
  private static final int SEQUENCE_HIGH = 1; // offsets of the header's fields
  private static final int OPCODE = 3;
  private static final int SIZE = 4;
  private static final int REQUEST_OPCODE = 5;
  private static final int DATA = 12;
  private static final int TERMINATE_SESSION = 1;
  private static final int RESET_SESSIONS = 2;
  private static final int ACK = 128;
  private static final int NAK = 129;
  private static final int FILE_NOT_FOUND = 10;
  private static final int BYTE = 8;

  private FileRefusals() {}

  /** The answer to a request. */
  public static FileTransferProtocol answer(FileTransferProtocol request, Sender to) {
    byte[] asked = Arrays.copyOf(request.payload(), PAYLOAD);
    byte[] answer = Arrays.copyOf(Arrays.copyOf(asked, DATA), PAYLOAD);
    int sequence = (asked[0] & 0xFF | (asked[SEQUENCE_HIGH] & 0xFF) << BYTE) + 1;
    answer[0] = (byte) sequence;
    answer[SEQUENCE_HIGH] = (byte) (sequence >> BYTE);
    boolean ends = asked[OPCODE] == TERMINATE_SESSION || asked[OPCODE] == RESET_SESSIONS;
    answer[OPCODE] = (byte) (ends ? ACK : NAK);
    answer[SIZE] = (byte) (ends ? 0 : 1);
    answer[REQUEST_OPCODE] = asked[OPCODE];
    answer[DATA] = (byte) (ends ? 0 : FILE_NOT_FOUND);
    return FileTransferProtocol.builder()
        .targetNetwork(0)
        .targetSystem(to.system())
        .targetComponent(to.component())
        .payload(answer)
        .build();
  }
}
