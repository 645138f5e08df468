/**
 * Holds docs/ to the code: examples, references and tables that would otherwise rot. What the code
 * itself does is tested where it stands.
 */
package org.u2sa.docs;
