package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.U2SAData;

/**
 * A message for one service, from it, or about it. A subclass's schema declares the name by {@link
 * org.u2sa.messages.schema.Schema#requiring}.
 *
 * @param <S> the subclass, which setters return
 */
public abstract class ServiceMessage<S extends ServiceMessage<S>> extends U2SAData {
  static final String SERVICE_NAME = "serviceName";

  /** The service. */
  public final String serviceName() {
    return required(SERVICE_NAME);
  }

  /** Sets {@link #serviceName()}. */
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

  @SuppressWarnings("unchecked") // a subclass names itself
  final S set(String name, String value) {
    field(name).set(this, value);
    return (S) this;
  }

  private MessageField<U2SAData> field(String name) {
    return ownType().field(name).orElseThrow();
  }
}
