package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.U2SAData;

/**
 * A message to, from or about one service. Subclass schemas declare the name by {@link
 * org.u2sa.messages.schema.Schema#requiring}.
 *
 * @param <S> the subclass, returned by setters
 */
public abstract class ServiceMessage<S extends ServiceMessage<S>> extends U2SAData {
  static final String SERVICE_NAME = "serviceName";

  /** Name of the service. */
  public final String serviceName() {
    return required(SERVICE_NAME);
  }

  public final S serviceName(String value) {
    return set(SERVICE_NAME, value);
  }

  final String required(String name) {
    MessageField<U2SAData> field = field(name);
    return (String)
        field
            .get(this)
            .orElseThrow(() -> new IllegalStateException(field + " is required and was never set"));
  }

  @SuppressWarnings("unchecked") // self type: S is the subclass
  final S set(String name, String value) {
    field(name).set(this, value);
    return (S) this;
  }

  private MessageField<U2SAData> field(String name) {
    return ownType().field(name).orElseThrow();
  }
}
