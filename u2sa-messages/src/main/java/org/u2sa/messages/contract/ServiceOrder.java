package org.u2sa.messages.contract;

import java.util.Optional;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * Order to a service's launcher to restart it or to replace it with another class (user story 8,
 * thesis 3.5.3).
 */
public final class ServiceOrder extends ServiceExchange<ServiceOrder> {
  private static final Schema<ServiceOrder> SCHEMA =
      Schema.of(ServiceOrder.class, ServiceOrder::new, U2SAData.TYPE)
          .since(2)
          .requiringId(REQUEST_ID)
          .requiring(SERVICE_NAME);
  private static final ValueField<ServiceOrder, ServiceAction> ACTION =
      SCHEMA.requiredChoice("action", ServiceAction.class);
  private static final ValueField<ServiceOrder, String> CLASS_NAME =
      SCHEMA.optionalName("className");
  private static final ValueField<ServiceOrder, String> OPERATOR = SCHEMA.name("operator", "");

  public static final MessageType<ServiceOrder> TYPE = SCHEMA.build();

  @Override
  public MessageType<ServiceOrder> type() {
    return TYPE;
  }

  /** Action to take. */
  public ServiceAction action() {
    return require(ACTION);
  }

  public ServiceOrder action(ServiceAction value) {
    return put(ACTION, value);
  }

  /** Fully qualified name of the replacing class; SWAP only. */
  public Optional<String> className() {
    return Optional.ofNullable(get(CLASS_NAME));
  }

  public ServiceOrder className(String value) {
    return put(CLASS_NAME, value);
  }

  /** Who gave the order: a user or a service. */
  public String operator() {
    return require(OPERATOR);
  }

  public ServiceOrder operator(String value) {
    return put(OPERATOR, value);
  }
}
