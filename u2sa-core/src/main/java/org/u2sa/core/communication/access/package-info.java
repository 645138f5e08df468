/** Who may connect, as which user, and what the user's roles permit. */
package org.u2sa.core.communication.access;
