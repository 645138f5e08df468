package org.u2sa.fuzz;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;

/**
 * The CBOR codec. The first byte chooses the type: its place among the standard types, with {@value
 * #SUBCLASS} added an unknown subclass of it, {@value #CHAIN} a chain that follows as text up to a
 * line end. The rest is the payload.
 */
public final class CodecTarget {
  private static final int SUBCLASS = 128;
  private static final int CHAIN = 255;
  private static final List<MessageType<?>> TYPES = List.copyOf(StandardTypes.registry().all());
  private static final MessageCodec CODEC = new MessageCodec(StandardTypes.registry());
  private static final MessageCodec LABELS =
      new MessageCodec(StandardTypes.registry(), WireForm.COMPACT);

  private CodecTarget() {}

  /** Called by the fuzzer. */
  public static void fuzzerTestOneInput(byte[] data) {
    if (data.length == 0) {
      return;
    }
    int choice = data[0] & 0xff;
    int from = 1;
    List<String> chain;
    if (choice == CHAIN) {
      int end = from;
      while (end < data.length && data[end] != '\n') {
        end++;
      }
      String text = new String(data, from, end - from, StandardCharsets.UTF_8);
      chain = text.isEmpty() ? List.of() : Arrays.asList(text.split("/", -1));
      from = Math.min(data.length, end + 1);
    } else {
      chain = new ArrayList<>(TYPES.get(choice % SUBCLASS % TYPES.size()).chain());
      if (choice >= SUBCLASS) {
        chain.add("Newer");
      }
    }
    decode(chain, Arrays.copyOfRange(data, from, data.length));
  }

  private static void decode(List<String> chain, byte[] payload) {
    U2SAData message;
    try {
      message = CODEC.decode(chain, payload);
    } catch (MalformedMessageException e) {
      Agreement.require(
          e.offset() >= 0 && e.offset() <= payload.length, "offset", e.offset(), payload.length);
      return;
    }
    byte[] written = message.serialize();
    U2SAData again;
    U2SAData labelled;
    try {
      again = CODEC.decode(message.typeChain(), written);
      labelled = CODEC.decode(message.typeChain(), LABELS.encode(message));
    } catch (MalformedMessageException e) {
      throw new AssertionError("what was written cannot be read: " + message, e);
    }
    Agreement.require(again.equals(message), "read again", again, message);
    Agreement.require(labelled.equals(message), "read by labels", labelled, message);
    Agreement.require(Arrays.equals(again.serialize(), written), "bytes", again, message);
    Agreement.require(message.copy().equals(message), "copy", message.copy(), message);
    Agreement.require(
        again.presenceVector() == message.presenceVector(), "presence", again, message);
    message.freeze();
  }
}
