/** The HTTP side of the embedded broker: the operator's page and who may open its WebSocket. */
package org.u2sa.core.communication.web;
