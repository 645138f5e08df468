/** Objects on and under water that boats and submarines look for (thesis 4.2.1.1, 4.3.1.2). */
package org.u2sa.messages.marine;
