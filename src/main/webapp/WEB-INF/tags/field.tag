<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="name" required="true" %>
<%@ attribute name="label" required="true" description="key of the text" %>
<%@ attribute name="hint" description="key of the text" %>
<%@ attribute name="type" %>
<%@ attribute name="autocomplete" %>
<%@ attribute name="inputmode" %>
<%@ attribute name="latin" type="java.lang.Boolean" description="an address or a code: it runs from left to right" %>
<%@ attribute name="errorAt" description="the error's name, if it is not the field's" %>
<%@ attribute name="id" description="if the field's name is not the only one of its kind" %>
<%@ attribute name="focus" type="java.lang.Boolean" %>
<%@ attribute name="optional" type="java.lang.Boolean" %>
<%@ attribute name="idle" type="java.lang.Boolean" description="another form of the page was sent, which has a field of this name too" %>
<%@ attribute name="value" description="the initial value" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<c:set var="fieldId" value="${empty id ? name : id}"/>
<c:set var="error" value="${idle ? null : errors[empty errorAt ? name : errorAt]}"/>
<c:set var="direction" value="${latin or not empty inputmode or type == 'email' or type == 'password' ? 'ltr' : 'auto'}"/>
<c:set var="explained" value="${not empty error or not empty hint}"/>
<%-- of a form that was refused the first wrong field, else the one that is named --%>
<c:set var="takesFocus" value="${empty errors ? focus : not empty error and empty focused}"/>
<c:if test="${takesFocus}"><c:set var="focused" value="true" scope="request"/></c:if>
<label for="${fieldId}"><fmt:message key="${label}"/></label>
<input id="${fieldId}" name="${name}" type="${empty type ? 'text' : type}" dir="${direction}"${optional ? '' : ' required'} autocomplete="${empty autocomplete ? 'off' : autocomplete}"
  <c:if test="${not empty inputmode}"> inputmode="${inputmode}"</c:if>
  <c:if test="${type != 'password'}"> value="${fn:escapeXml(idle or param[name] == null ? value : param[name])}"</c:if>
  <c:if test="${not empty error}"> aria-invalid="true"</c:if>
  <c:if test="${explained}"> aria-describedby="${fieldId}-help"</c:if>
  <c:if test="${takesFocus}"> autofocus</c:if>>
<c:if test="${explained}"><small id="${fieldId}-help"><c:choose><c:when test="${not empty error}"><bdi><c:out value="${error}"/></bdi></c:when><c:otherwise><fmt:message key="${hint}"/></c:otherwise></c:choose></small></c:if>
