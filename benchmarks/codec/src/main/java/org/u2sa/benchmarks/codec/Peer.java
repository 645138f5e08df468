package org.u2sa.benchmarks.codec;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.google.protobuf.Parser;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.List;
import org.msgpack.jackson.dataformat.MessagePackFactory;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** A codec, as its users use it: from an object to bytes and back. */
enum Peer {
  OURS {
    @Override
    Codec with(Contents contents) {
      U2SAData message = contents.ours();
      MessageCodec codec = new MessageCodec(StandardTypes.registry());
      List<String> chain = message.typeChain();
      return new Codec(message::serialize, bytes -> codec.decode(chain, bytes));
    }
  },
  JACKSON_JSON {
    @Override
    Codec with(Contents contents) {
      return jackson(new ObjectMapper(), contents.bean());
    }
  },
  MESSAGE_PACK {
    @Override
    Codec with(Contents contents) {
      return jackson(new ObjectMapper(new MessagePackFactory()), contents.bean());
    }
  },
  PROTOBUF {
    @Override
    Codec with(Contents contents) {
      com.google.protobuf.Message message = contents.protobuf();
      Parser<?> parser = message.getParserForType();
      return new Codec(message::toByteArray, parser::parseFrom);
    }
  },
  JAVA {
    @Override
    Codec with(Contents contents) {
      Object bean = contents.bean();
      return new Codec(
          () -> {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
              out.writeObject(bean);
            }
            return bytes.toByteArray();
          },
          bytes -> new ObjectInputStream(new ByteArrayInputStream(bytes)).readObject());
    }
  };

  /** Both ways of one codec with one message. */
  record Codec(Encoder encoder, Decoder decoder) {}

  /** To bytes. */
  interface Encoder {
    byte[] encode() throws Exception;
  }

  /** From bytes. */
  interface Decoder {
    Object decode(byte[] bytes) throws Exception;
  }

  abstract Codec with(Contents contents);

  private static Codec jackson(ObjectMapper mapper, Object bean) {
    Class<?> type = bean.getClass();
    return new Codec(() -> mapper.writeValueAsBytes(bean), bytes -> mapper.readValue(bytes, type));
  }
}
