/** Authentication and authorisation of the broker's clients. */
package org.u2sa.core.communication.access;
