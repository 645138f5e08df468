package org.u2sa.messages.schema;

import java.io.IOException;
import java.util.List;
import java.util.function.Function;

/** A kind of single values, given by its four functions. */
record SingleKind<V>(
    Kind kind, Function<Object, V> check, Function<String, V> parse, Writer<V> out, Reader<V> in)
    implements ValueKind<V> {

  /** Writes one value. */
  interface Writer<V> {
    void write(CborWriter out, V value) throws IOException;
  }

  /** Reads one value. */
  interface Reader<V> {
    V read(CborReader in) throws IOException, MalformedMessageException;
  }

  @Override
  public V checked(Object value) {
    return check.apply(value);
  }

  @Override
  public V parsed(List<String> texts) {
    return parse.apply(ValueKind.only(texts));
  }

  @Override
  public void write(CborWriter writer, V value) throws IOException {
    out.write(writer, value);
  }

  @Override
  public V read(CborReader reader) throws IOException, MalformedMessageException {
    return in.read(reader);
  }
}
