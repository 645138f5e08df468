/** Goals of a mission and lists of them (thesis 3.2.3.3, 3.2.3.4). */
package org.u2sa.messages.goal;
