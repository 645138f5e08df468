package org.u2sa.benchmarks.codec;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.google.protobuf.Parser;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.List;
import java.util.function.Supplier;
import org.msgpack.jackson.dataformat.MessagePackFactory;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** A codec, as its users use it: from an object to bytes and back. */
enum Peer {
  OURS {
    @Override
    Codec with(Contents contents) {
      return ours(contents, WireForm.READABLE);
    }
  },
  OURS_COMPACT {
    @Override
    Codec with(Contents contents) {
      return ours(contents, WireForm.COMPACT);
    }
  },
  JACKSON_JSON {
    @Override
    Codec with(Contents contents) {
      return jackson(new ObjectMapper(), contents);
    }
  },
  MESSAGE_PACK {
    @Override
    Codec with(Contents contents) {
      return jackson(new ObjectMapper(new MessagePackFactory()), contents);
    }
  },
  PROTOBUF {
    @Override
    Codec with(Contents contents) {
      Parser<?> parser = contents.protobuf().getParserForType();
      return new Codec(() -> encoder(contents.protobuf()), parser::parseFrom);
    }

    private Encoder encoder(com.google.protobuf.Message message) {
      return message::toByteArray;
    }
  },
  JAVA {
    @Override
    Codec with(Contents contents) {
      return new Codec(
          () -> encoder(contents.bean()),
          bytes -> new ObjectInputStream(new ByteArrayInputStream(bytes)).readObject());
    }

    private Encoder encoder(Object bean) {
      return () -> {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
          out.writeObject(bean);
        }
        return bytes.toByteArray();
      };
    }
  };

  /**
   * Both ways of one codec with one contents.
   *
   * @param fresh makes a message that was never encoded before
   */
  record Codec(Supplier<Encoder> fresh, Decoder decoder) {}

  /** One message to bytes. */
  interface Encoder {
    byte[] encode() throws Exception;
  }

  /** From bytes. */
  interface Decoder {
    Object decode(byte[] bytes) throws Exception;
  }

  abstract Codec with(Contents contents);

  private static Codec ours(Contents contents, WireForm form) {
    MessageCodec codec = new MessageCodec(StandardTypes.registry(), form);
    List<String> chain = contents.ours().typeChain();
    return new Codec(() -> encoder(codec, contents.ours()), bytes -> codec.decode(chain, bytes));
  }

  private static Encoder encoder(MessageCodec codec, U2SAData message) {
    message.freeze(); // as whoever publishes it does
    return () -> codec.encode(message);
  }

  private static Codec jackson(ObjectMapper mapper, Contents contents) {
    Class<?> type = contents.bean().getClass();
    return new Codec(
        () -> encoder(mapper, contents.bean()), bytes -> mapper.readValue(bytes, type));
  }

  private static Encoder encoder(ObjectMapper mapper, Object bean) {
    return () -> mapper.writeValueAsBytes(bean);
  }
}
