/**
 * The Communication Manager (thesis 3.4, 4.5.1.1): the embedded broker and the bridge between it
 * and the direct path. The only package that knows Moquette.
 */
package org.u2sa.core.communication;
